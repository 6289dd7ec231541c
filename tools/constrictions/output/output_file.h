// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_OUTPUT_FILE_H
#define CONSTRICTIONS_OUTPUT_FILE_H

#include <stdexcept>
#include <string>
#include <vector>

namespace constrictions {

/// An output that cannot be written; the message is one line that begins with the name of the file.
class Output_file_error : public std::runtime_error
{
public:
  Output_file_error(const std::string& file, const std::string& reason);
};

struct Output_file
{
  std::string name;
  std::string content;
};

/// creates the folder, and those above it, if missing.
void create_folder(const std::string& name);

/// throws `Output_file_error` if there is no such folder, and it could not be created now. Leaves nothing behind.
void check_folder(const std::string& name);

/// throws `Output_file_error` if a file of this name could not be written now, in a folder that would be created if it is
/// missing. Leaves nothing behind.
void check_writable(const std::string& name);

/// writes the files beside their places first and renames them when all are complete, so that none is ever seen half
/// written. Signals that would end the program wait meanwhile. Folders are created if missing. What is no ordinary file, a pipe or a device, is written to directly. Throws `Output_file_error`.
/// \param obsolete files that are removed, where they are, when all are complete and before the last is renamed: so
///   that one may say which the others are.
void write_files(const std::vector<Output_file>& files, const std::vector<std::string>& obsolete = {});

/// writes to the standard output. Throws `Output_file_error`.
void write_to_standard_output(const std::string& content);

} // namespace constrictions

#endif // CONSTRICTIONS_OUTPUT_FILE_H
