// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/text_scanner.h"
#include "input/triangle_soup.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace constrictions {

namespace {

// What follows the coordinates of a vertex (normal, colour, texture) is not read, so the prefixes ST, C and N do not
// matter.
void check_keyword(Text_scanner& scanner, const Input_file& file)
{
  std::string_view keyword = scanner.next_line() ? scanner.word() : std::string_view();
  for(std::string_view prefix : {"ST", "C", "N"})
    if(keyword.substr(0, prefix.size()) == prefix)
      keyword.remove_prefix(prefix.size());
  if(keyword == "4OFF" || keyword == "nOFF" || keyword == "4nOFF")
    file.fail("OFF files with points of other than three coordinates cannot be read");
  if(keyword != "OFF")
    file.fail("not an OFF file: it does not begin with OFF");
}

std::size_t read_count(Text_scanner& scanner, const std::string& what)
{
  std::size_t count = 0;
  scanner.next_line();
  if(!scanner.read(count))
    scanner.fail_at_word("OFF header", "the number of " + what);
  return count;
}

void go_to_element(Text_scanner& scanner, const char* kind, std::size_t i, std::size_t count)
{
  if(!scanner.next_line())
    scanner.fail("the file ends at " + (kind + (" " + std::to_string(i))) + " of the " + std::to_string(count) +
                 " that its header announces");
}

} // namespace

Triangle_soup read_off(const Input_file& file)
{
  Text_scanner scanner(file);
  check_keyword(scanner, file);
  const std::size_t place = scanner.offset();
  if(scanner.next_line() && scanner.word() == "BINARY")
    file.fail("binary OFF files cannot be read: save it as text or as PLY");
  scanner = Text_scanner(file, place);
  const std::size_t nv = read_count(scanner, "vertices"), nf = read_count(scanner, "faces");
  scanner.skip_line();

  // a line takes at least six bytes: what the header claims does not decide on the memory
  Triangle_soup soup;
  soup.points.reserve((std::min)(nv, scanner.remaining() / 6 + 1));
  for(std::size_t v = 0; v < nv; ++v, scanner.skip_line())
  {
    go_to_element(scanner, "vertex", v, nv);
    double x, y, z;
    if(!scanner.read(x) || !scanner.read(y) || !scanner.read(z))
      scanner.fail_at_word("vertex " + std::to_string(v), "a coordinate");
    soup.points.emplace_back(x, y, z);
  }

  soup.corners.reserve(3 * (std::min)(nf, scanner.remaining() / 6 + 1));
  for(std::size_t f = 0; f < nf; ++f, scanner.skip_line())
  {
    go_to_element(scanner, "face", f, nf);
    unsigned long long n = 0;
    if(!scanner.read(n))
      scanner.fail_at_word("face " + std::to_string(f), "a number of vertices");
    if(n != 3)
      throw_not_triangular(f, n);
    for(int i = 0; i < 3; ++i)
    {
      long long v = 0;
      if(!scanner.read(v))
        scanner.fail_at_word("face " + std::to_string(f), "a vertex number");
      soup.corners.push_back(checked_index(f, v, nv));
    }
  }
  return soup;
}

} // namespace constrictions
