// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/labels_file.h"

#include "input/input_file.h"
#include "input/text_scanner.h"

#include <string>
#include <string_view>

namespace constrictions {

std::vector<Label> read_labels_file(const std::string& name, std::size_t number_of_faces)
{
  const Input_file file = read_input_file(name);
  const std::string faces = "the mesh has " + std::to_string(number_of_faces) + " faces";
  Text_scanner scanner(file);
  std::vector<Label> labels;
  for(; scanner.next_line(); scanner.skip_line())
  {
    const std::string_view word = scanner.word();
    Label label = 0;
    if(!Text_scanner::parse(word, label))
      scanner.fail(quoted(word) + " is not a label, which is a whole number");
    if(const std::string_view more = scanner.word(); !more.empty())
      scanner.fail(quoted(more) + " follows a label: give one a line");
    if(labels.size() == number_of_faces)
      scanner.fail("there are more labels than faces: " + faces);
    labels.push_back(label);
  }
  if(labels.size() < number_of_faces)
    scanner.fail("the file ends after " + std::to_string(labels.size()) + " labels, but " + faces);
  return labels;
}

} // namespace constrictions
