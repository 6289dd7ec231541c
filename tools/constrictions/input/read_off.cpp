// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/byte_reader.h"
#include "input/readers.h"
#include "input/text_scanner.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace constrictions {

namespace {

// What the first word tells of the vertices: "STCN4OFF".
struct Off_kind
{
  bool has_texture = false, has_colour = false, has_normal = false, is_homogeneous = false, has_dimension = false;
};

// Nothing if the word is no keyword of OFF.
std::optional<Off_kind> parse_keyword(std::string word)
{
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::toupper(c); });
  Off_kind kind;
  std::string_view rest = word;
  // each at most once, in any order: the order in which they are written is not that of the numbers of a vertex
  const auto take = [&rest](std::string_view prefix, bool& is_there) {
    if(is_there || rest.substr(0, prefix.size()) != prefix)
      return false;
    rest.remove_prefix(prefix.size());
    return is_there = true;
  };
  // a small n is the dimension, and "NOFF" in capitals has normals
  while(take("ST", kind.has_texture) || take("C", kind.has_colour) || take("N", kind.has_normal) ||
        take("4", kind.is_homogeneous) || take("N", kind.has_dimension))
  {}
  return rest == "OFF" ? std::optional<Off_kind>(kind) : std::nullopt;
}

class Off_reader
{
public:
  explicit Off_reader(const Input_file& file) : m_file(file), m_scanner(file) {}

  Polygon_soup read()
  {
    read_keyword();
    Text_scanner ahead = m_scanner;
    if(ahead.next_line() && lower_case(ahead.word()) == "binary")
    {
      m_scanner = ahead;
      m_scanner.skip_line();
      return read_binary();
    }
    if(m_kind.has_dimension)
    {
      m_dimension = read_count("dimensions");
      if(m_dimension != 3)
        m_file.fail("points of " + std::to_string(m_dimension) + " dimensions cannot be read, only of three");
    }
    m_nv = read_count("vertices");
    m_nf = read_count("faces");
    const Text_scanner counts = m_scanner;

    // An element a line, as nearly all programs write it, and then nothing behind its numbers matters; or numbers that
    // go on over the ends of lines, and then each counts, and none is left over: else a number that is missing
    // somewhere would shift all that follow.
    std::exception_ptr failure;
    for(const auto& [vertices_in_lines, faces_in_lines] :
        std::array<std::pair<bool, bool>, 4>{{{true, true}, {false, false}, {true, false}, {false, true}}})
      try
      {
        m_scanner = counts;
        m_soup = Polygon_soup();
        if(vertices_in_lines)
          m_scanner.skip_line(); // the number of edges
        else
          skip_number_of_edges();
        read_vertices(vertices_in_lines);
        if(!vertices_in_lines && faces_in_lines && !m_scanner.word().empty())
          m_scanner.fail("the last vertex is followed by another number in its line");
        read_faces(faces_in_lines);
        if(!faces_in_lines && m_scanner.next_line())
          m_scanner.fail("the last face is followed by further numbers");
        return std::move(m_soup);
      }
      catch(const std::exception&)
      {
        if(!failure)
          failure = std::current_exception();
      }
    std::rethrow_exception(failure);
  }

private:
  void read_keyword()
  {
    const Text_scanner begin = m_scanner;
    const std::string word(m_scanner.next_line() ? m_scanner.word() : std::string_view());
    if(const std::optional<Off_kind> kind = parse_keyword(word))
    {
      m_kind = *kind;
      if(m_kind.has_normal && word.find('n') != std::string::npos && word.find("OFF") != std::string::npos)
        std::swap(m_kind.has_normal, m_kind.has_dimension); // nOFF
      return;
    }
    // the keyword may be left out
    std::size_t count = 0;
    if(!Text_scanner::parse(word, count))
      m_file.fail("not an OFF file: it does not begin with OFF");
    m_scanner = begin;
  }

  std::size_t read_count(const std::string& what)
  {
    std::size_t count = 0;
    m_scanner.next_line();
    if(!m_scanner.read(count))
      m_scanner.fail_at_word("OFF header", "the number of " + what);
    return count;
  }

  void skip_number_of_edges()
  {
    std::size_t count = 0;
    Text_scanner ahead = m_scanner;
    if(Text_scanner::parse(ahead.word_of_text(), count))
      m_scanner = ahead;
  }

  void go_to_element(const char* kind, std::size_t i, std::size_t count)
  {
    if(!m_scanner.next_line())
      fail_at_end(kind, i, count);
  }

  [[noreturn]] void fail_at_end(const char* kind, std::size_t i, std::size_t count)
  {
    m_file.fail("the file ends at " + (kind + (" " + std::to_string(i))) + " of the " + std::to_string(count) +
                " that its header announces");
  }

  double read_number(bool in_lines, const char* kind, std::size_t i, const char* expected)
  {
    double value = 0;
    if(!Text_scanner::parse(in_lines ? m_scanner.word() : m_scanner.word_of_text(), value))
      m_scanner.fail_at_word(kind + (" " + std::to_string(i)), expected);
    return value;
  }

  // of each vertex, behind its position
  int number_of_further_numbers() const
  {
    return (m_kind.has_normal ? 3 : 0) + (m_kind.has_colour ? 4 : 0) + (m_kind.has_texture ? 2 : 0);
  }

  void add_point(double x, double y, double z, double w)
  {
    m_soup.points.push_back(m_kind.is_homogeneous ? Point(x / w, y / w, z / w) : Point(x, y, z));
  }

  void read_vertices(bool in_lines)
  {
    // a line takes at least six bytes: what the header claims does not decide on the memory
    m_soup.points.reserve((std::min)(m_nv, m_scanner.remaining() / 6 + 1));
    for(std::size_t v = 0; v < m_nv; ++v)
    {
      go_to_element("vertex", v, m_nv);
      std::array<double, 4> c = {0, 0, 0, 1};
      for(std::size_t i = 0; i < (m_kind.is_homogeneous ? 4u : 3u); ++i)
        c[i] = read_number(in_lines, "vertex", v, "a coordinate");
      add_point(c[0], c[1], c[2], c[3]);
      if(in_lines)
        m_scanner.skip_line();
      else
        for(int i = 0; i < number_of_further_numbers(); ++i)
          read_number(false, "vertex", v, "a number");
    }
  }

  void read_faces(bool in_lines)
  {
    m_soup.corners.reserve(3 * (std::min)(m_nf, m_scanner.remaining() / 6 + 1));
    for(std::size_t f = 0; f < m_nf; ++f)
    {
      go_to_element("face", f, m_nf);
      const auto read_integer = [&](const char* expected) {
        long long value = 0;
        if(!Text_scanner::parse(in_lines ? m_scanner.word() : m_scanner.word_of_text(), value))
          m_scanner.fail_at_word("face " + std::to_string(f), expected);
        return value;
      };
      const long long n = read_integer("a number of vertices");
      if(n < 1 && !in_lines)
        m_scanner.fail("face " + std::to_string(f) + ": " + std::to_string(n) + " is not a number of vertices");
      for(long long i = 0; i < n; ++i)
        m_soup.corners.push_back(checked_index(f, read_integer("a vertex number"), m_nv));
      m_soup.end_face();
      if(in_lines)
        m_scanner.skip_line();
    }
  }

  // Geomview's: 32-bit numbers, big-endian, and of each face a number of colour components and these. Some programs
  // write them as their machine has them, and some nothing of colours.
  Polygon_soup read_binary()
  {
    try
    {
      return read_binary(true);
    }
    catch(const std::exception&)
    {
      try
      {
        m_soup = Polygon_soup();
        return read_binary(false);
      }
      catch(const std::exception&)
      {}
      throw;
    }
  }

  // Without colours nothing may be missing or left over: else a file that was cut off would be taken for one of these.
  Polygon_soup read_binary(bool has_colours)
  {
    std::size_t place = m_scanner.offset();
    const std::string& content = m_file.content;
    const auto remaining = [&] { return content.size() - place; };
    if(remaining() < 12)
      m_file.fail("the file ends in the counts of a binary OFF file");
    const auto counts_fit = [&](bool is_little_endian) {
      const std::uint64_t nv = number_from_bytes<std::uint32_t>(content.data() + place, is_little_endian),
                          nf = number_from_bytes<std::uint32_t>(content.data() + place + 4, is_little_endian);
      return 12 * nv + 8 * nf <= remaining();
    };
    const bool is_little_endian = !counts_fit(false) && counts_fit(true);
    const auto next_integer = [&](const char* kind, std::size_t i, std::size_t count) {
      if(remaining() < 4)
        fail_at_end(kind, i, count);
      place += 4;
      return number_from_bytes<std::int32_t>(content.data() + place - 4, is_little_endian);
    };
    const auto next_float = [&](std::size_t v) {
      if(remaining() < 4)
        fail_at_end("vertex", v, m_nv);
      place += 4;
      return static_cast<double>(number_from_bytes<float>(content.data() + place - 4, is_little_endian));
    };

    m_nv = number_from_bytes<std::uint32_t>(content.data() + place, is_little_endian);
    m_nf = number_from_bytes<std::uint32_t>(content.data() + place + 4, is_little_endian);
    place += 12;
    m_soup.points.reserve((std::min)(m_nv, remaining() / 12 + 1));
    for(std::size_t v = 0; v < m_nv; ++v)
    {
      const double x = next_float(v), y = next_float(v), z = next_float(v);
      add_point(x, y, z, m_kind.is_homogeneous ? next_float(v) : 1);
      for(int i = 0; i < number_of_further_numbers(); ++i)
        next_float(v);
    }
    for(std::size_t f = 0; f < m_nf; ++f)
    {
      const std::int32_t n = next_integer("face", f, m_nf);
      if(!has_colours && n < 3) // that is a number of colours
        m_file.fail("face " + std::to_string(f) + " has fewer than three vertices");
      for(std::int32_t i = 0; i < n; ++i)
        m_soup.corners.push_back(checked_index(f, next_integer("face", f, m_nf), m_nv));
      m_soup.end_face();
      if(!has_colours)
        continue;
      // what ends with the last face has no colours
      const std::int32_t colours = remaining() == 0 ? 0 : next_integer("face", f, m_nf);
      for(std::int32_t i = 0; i < colours; ++i)
        next_integer("face", f, m_nf);
    }
    if(!has_colours && remaining() > 0)
      m_file.fail("the last face is followed by further bytes");
    return std::move(m_soup);
  }

  const Input_file& m_file;
  Text_scanner m_scanner;
  Off_kind m_kind;
  std::size_t m_dimension = 3, m_nv = 0, m_nf = 0;
  Polygon_soup m_soup;
};

} // namespace

bool is_off_keyword(std::string_view word) { return parse_keyword(std::string(word)).has_value(); }

Polygon_soup read_off(const Input_file& file) { return Off_reader(file).read(); }

} // namespace constrictions
