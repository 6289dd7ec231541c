// SPDX-License-Identifier: GPL-3.0-or-later
#include "zip_archive.h"

#include <zip.h>

#include <cstddef>
#include <ctime>
#include <stdexcept>

namespace constrictions {

namespace {

// What libzip says of an error.
std::string text_of(zip_error_t& error)
{
  const std::string result = zip_error_strerror(&error);
  zip_error_fini(&error);
  return result;
}

} // namespace

struct Zip_archive::Archive
{
  zip_t* zip = nullptr;
  ~Archive()
  {
    if(zip != nullptr)
      zip_discard(zip);
  }
};

bool has_zip() { return true; }

Zip_archive::Zip_archive(const Input_file& file) : m_file(file), m_archive(std::make_unique<Archive>())
{
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* const source = zip_source_buffer_create(file.content.data(), file.content.size(), 0, &error);
  if(source == nullptr)
    file.fail("not a zip archive: " + text_of(error));
  m_archive->zip = zip_open_from_source(source, ZIP_RDONLY, &error);
  if(m_archive->zip == nullptr)
  {
    zip_source_free(source);
    file.fail("not a zip archive: " + text_of(error));
  }
}

Zip_archive::~Zip_archive() = default;

std::string Zip_archive::content(const std::string& name) const
{
  const std::string place = "file " + constrictions::quoted(name) + " in it ";
  zip_stat_t stat;
  zip_stat_init(&stat);
  if(zip_stat(m_archive->zip, name.c_str(), ZIP_FL_NOCASE, &stat) != 0 || (stat.valid & ZIP_STAT_SIZE) == 0)
    m_file.fail(place + "is missing");
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> in(zip_fopen_index(m_archive->zip, stat.index, 0),
                                                             &zip_fclose);
  if(in == nullptr)
    m_file.fail(place + "cannot be read: " + zip_strerror(m_archive->zip));
  // the announced size may be a lie, so memory is taken as bytes come
  std::string result;
  for(const std::size_t chunk = std::size_t(1) << 20;;)
  {
    const std::size_t filled = result.size();
    result.resize(filled + chunk);
    const zip_int64_t got = zip_fread(in.get(), &result[filled], chunk);
    if(got < 0)
      m_file.fail(place + "cannot be read: " + zip_file_strerror(in.get()));
    result.resize(filled + static_cast<std::size_t>(got));
    if(got == 0)
      return result;
  }
}

std::string zip_of(const std::vector<Zip_entry>& entries)
{
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* const source = zip_source_buffer_create(nullptr, 0, 0, &error);
  zip_t* const zip = source == nullptr ? nullptr : zip_open_from_source(source, ZIP_TRUNCATE, &error);
  if(zip == nullptr)
  {
    zip_source_free(source);
    throw std::runtime_error("a zip archive cannot be written: " + text_of(error));
  }
  zip_source_keep(source);

  // the first time that there is in an archive, whatever the time zone
  std::tm first = {};
  first.tm_year = 80;
  first.tm_mday = 1;
  first.tm_hour = 12;
  first.tm_isdst = -1;
  const std::time_t time = std::mktime(&first);
  bool is_written = true;
  for(const Zip_entry& entry : entries)
  {
    zip_source_t* const content = zip_source_buffer(zip, entry.content.data(), entry.content.size(), 0);
    const zip_int64_t index =
        content == nullptr ? -1 : zip_file_add(zip, entry.name.c_str(), content, ZIP_FL_ENC_UTF_8);
    if(index < 0)
      zip_source_free(content);
    is_written = is_written && index >= 0 && zip_file_set_mtime(zip, static_cast<zip_uint64_t>(index), time, 0) == 0;
  }
  if(!is_written || zip_close(zip) != 0)
  {
    const std::string reason = zip_strerror(zip);
    zip_discard(zip);
    zip_source_free(source);
    throw std::runtime_error("a zip archive cannot be written: " + reason);
  }

  std::string result;
  if(zip_source_open(source) == 0)
  {
    zip_source_seek(source, 0, SEEK_END);
    const zip_int64_t size = zip_source_tell(source);
    zip_source_seek(source, 0, SEEK_SET);
    result.resize(static_cast<std::size_t>(size));
    if(zip_source_read(source, result.data(), result.size()) != size)
      result.clear();
    zip_source_close(source);
  }
  zip_source_free(source);
  if(result.empty())
    throw std::runtime_error("a zip archive cannot be written");
  return result;
}

} // namespace constrictions
