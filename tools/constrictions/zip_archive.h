// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_ZIP_ARCHIVE_H
#define CONSTRICTIONS_ZIP_ARCHIVE_H

#include "input/input_file.h"

#include <memory>
#include <string>
#include <vector>

namespace constrictions {

/// whether the program was built with libzip. Without it the functions below fail, and say so.
bool has_zip();

/// A zip archive in memory that is read.
class Zip_archive
{
public:
  /// `file` must live as long as this. Throws `Input_file_error` if it is not a zip archive.
  explicit Zip_archive(const Input_file& file);
  ~Zip_archive();

  /// the file of that name in the archive, whatever the case of its letters. Throws `Input_file_error` if there is none,
  /// or it is damaged or encrypted.
  std::string content(const std::string& name) const;

private:
  struct Archive;
  const Input_file& m_file;
  std::unique_ptr<Archive> m_archive;
};

/// A file in an archive that is written.
struct Zip_entry
{
  std::string name;
  std::string content;
};

/// a zip archive of these files, which bear no time, so that it is the same each time. Throws `std::runtime_error`.
std::string zip_of(const std::vector<Zip_entry>& entries);

} // namespace constrictions

#endif // CONSTRICTIONS_ZIP_ARCHIVE_H
