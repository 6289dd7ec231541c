// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_VIEW_PAGE_H
#define CONSTRICTIONS_VIEW_PAGE_H

#include "output/parts.h"
#include "output/report.h"
#include "view/playback.h"

#include "page_template.h"

#include <string>

namespace constrictions {

/// The prominence of the weakest curves in a page, unless the options allow weaker ones: the page has a slider that
/// shows them.
constexpr double least_prominence_in_page = 0.01;

/// a page that shows the mesh, its parts, its constrictions, and how they were found.
///
/// \param report with the constrictions that the page holds
/// \param parts of the surface cut along all of these
/// \param playback of these
/// \param prominence those that are less prominent are not shown at first
/// \throws std::logic_error if there is no template
std::string view_page(const Report& report, const Parts& parts, const Playback& playback, double prominence);

} // namespace constrictions

#endif // CONSTRICTIONS_VIEW_PAGE_H
