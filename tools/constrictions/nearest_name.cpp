// SPDX-License-Identifier: GPL-3.0-or-later
#include "nearest_name.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>

namespace constrictions {

namespace {

std::string without_dashes(const std::string& name)
{
  return name.substr((std::min)(name.find_first_not_of('-'), name.size()));
}

// The edit distance with exchanges of neighbours, of which no letter takes part in two.
std::size_t distance(const std::string& a, const std::string& b)
{
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for(std::size_t i = 0; i <= a.size(); ++i)
    d[i][0] = i;
  std::iota(d[0].begin(), d[0].end(), std::size_t(0));
  for(std::size_t i = 1; i <= a.size(); ++i)
    for(std::size_t j = 1; j <= b.size(); ++j)
    {
      d[i][j] = (std::min)({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if(i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = (std::min)(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

} // namespace

std::string nearest_name(const std::string& given, const std::vector<std::string>& names)
{
  const std::string word = without_dashes(given);
  if(word.size() > 100) // no name is as long
    return "";
  std::string nearest, continued;
  std::size_t least = (std::numeric_limits<std::size_t>::max)(), continuations = 0;
  for(const std::string& name : names)
  {
    const std::string other = without_dashes(name);
    const std::size_t d = distance(word, other);
    if(d < least && d <= (std::max)(word.size() / 3, std::size_t(1)) && d < other.size())
    {
      least = d;
      nearest = name;
    }
    if(word.size() >= 3 && other.compare(0, word.size(), word) == 0)
    {
      ++continuations;
      continued = name;
    }
  }
  return !nearest.empty() ? nearest : continuations == 1 ? continued : "";
}

} // namespace constrictions
