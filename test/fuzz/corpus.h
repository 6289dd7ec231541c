// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FUZZ_CORPUS_H
#define FUZZ_CORPUS_H

#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace fuzz {

// The inputs of a corpus: a line of hexadecimal digits each. Empty lines and those that start with # are passed over.
inline std::vector<std::vector<std::uint8_t>> read_corpus(const std::string& name)
{
  std::ifstream in(name);
  if(!in)
    throw std::runtime_error("cannot read " + name);
  std::vector<std::vector<std::uint8_t>> result;
  for(std::string line; std::getline(in, line);)
  {
    if(line.empty() || line[0] == '#')
      continue;
    result.emplace_back();
    for(std::size_t i = 0; i + 1 < line.size(); i += 2)
      result.back().push_back(static_cast<std::uint8_t>(std::stoi(line.substr(i, 2), nullptr, 16)));
  }
  return result;
}

} // namespace fuzz

#endif // FUZZ_CORPUS_H
