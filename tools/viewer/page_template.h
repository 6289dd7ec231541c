// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_PAGE_TEMPLATE_H
#define CONSTRICTIONS_PAGE_TEMPLATE_H

#include <string>

namespace constrictions {

/// the page of the viewer without data, with its scripts and styles; empty if it could not be built
const std::string& page_template();

} // namespace constrictions

#endif // CONSTRICTIONS_PAGE_TEMPLATE_H
