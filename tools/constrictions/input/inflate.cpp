// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/inflate.h"

#include <zlib.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <utility>

namespace constrictions {

void inflate(Input_file& file)
{
  const std::string& packed = file.content;
  if(packed.size() < 2 || packed.compare(0, 2, "\x1F\x8B") != 0)
    return;
  z_stream stream = {};
  const int gzip = 16;
  if(inflateInit2(&stream, MAX_WBITS + gzip) != Z_OK)
    file.fail("cannot be decompressed: zlib cannot be started");
  const std::unique_ptr<z_stream, int (*)(z_stream*)> end(&stream, &inflateEnd);

  std::string result;
  std::size_t read = 0;
  const std::size_t chunk = std::size_t(1) << 20;
  for(;;)
  {
    const std::size_t piece =
        (std::min)(packed.size() - read, static_cast<std::size_t>((std::numeric_limits<uInt>::max)()));
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data() + read));
    stream.avail_in = static_cast<uInt>(piece);
    const std::size_t filled = result.size();
    result.resize(filled + (std::max)(chunk, filled / 2));
    const std::size_t room =
        (std::min)(result.size() - filled, static_cast<std::size_t>((std::numeric_limits<uInt>::max)()));
    stream.next_out = reinterpret_cast<Bytef*>(&result[filled]);
    stream.avail_out = static_cast<uInt>(room);
    const int status = ::inflate(&stream, Z_NO_FLUSH);
    read += piece - stream.avail_in;
    const std::size_t written = room - stream.avail_out;
    result.resize(filled + written);
    if(status == Z_STREAM_END)
    {
      // a file may be made of several, one behind the other; other bytes behind the last do not matter
      if(packed.size() - read < 2 || packed.compare(read, 2, "\x1F\x8B") != 0)
        break;
      inflateReset(&stream);
    }
    else if(status != Z_OK && status != Z_BUF_ERROR)
      file.fail("cannot be decompressed: " + std::string(stream.msg != nullptr ? stream.msg : "damaged"));
    else if(read == packed.size() && written < room)
      file.fail("cannot be decompressed: the file ends too early");
  }
  file.content = std::move(result);
}

} // namespace constrictions
