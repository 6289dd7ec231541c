// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_INPUT_FILE_H
#define CONSTRICTIONS_INPUT_FILE_H

#include <stdexcept>
#include <string>
#include <string_view>

namespace constrictions {

/// An input file that cannot be read; the message is one line that begins with the name of the file. Control characters
/// are replaced in it, so a reason may name what the file has.
class Input_file_error : public std::runtime_error
{
public:
  Input_file_error(const std::string& file, const std::string& reason);
};

/// The name of a file and its bytes.
struct Input_file
{
  std::string name;
  std::string content;

  /// throws `Input_file_error` with the name of this file.
  [[noreturn]] void fail(const std::string& reason) const { throw Input_file_error(name, reason); }
};

/// reads a whole file. Throws `Input_file_error` for a folder, a device, and a file that cannot be read.
Input_file read_input_file(const std::string& name);

/// reads the standard input to its end. Its name is "-".
Input_file read_standard_input();

/// what the system says of a value of `errno`
std::string error_text(int error);

/// `text` with control characters replaced, so that it can stand in a message of one line.
std::string printable(std::string_view text);

/// `text` in quotation marks, printable and shortened.
std::string quoted(std::string_view text);

} // namespace constrictions

#endif // CONSTRICTIONS_INPUT_FILE_H
