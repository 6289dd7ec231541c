// SPDX-License-Identifier: GPL-3.0-or-later

// In place of zip_archive.cpp where libzip is missing.
#include "zip_archive.h"

#include <stdexcept>

namespace constrictions {

struct Zip_archive::Archive
{};

bool has_zip() { return false; }

Zip_archive::Zip_archive(const Input_file& file) : m_file(file)
{
  m_file.fail("this program was built without libzip, which reads 3MF files");
}

Zip_archive::~Zip_archive() = default;

std::string Zip_archive::content(const std::string&) const { return ""; }

std::string zip_of(const std::vector<Zip_entry>&)
{
  throw std::runtime_error("this program was built without libzip, which writes 3MF files");
}

} // namespace constrictions
