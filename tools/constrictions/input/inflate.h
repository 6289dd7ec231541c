// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_INFLATE_H
#define CONSTRICTIONS_INFLATE_H

#include "input/input_file.h"

namespace constrictions {

/// replaces the content of a gzipped file, told by its first bytes, by what was compressed; other files stay as they
/// are. Throws `Input_file_error` for a file that is damaged or ends too early.
void inflate(Input_file& file);

} // namespace constrictions

#endif // CONSTRICTIONS_INFLATE_H
