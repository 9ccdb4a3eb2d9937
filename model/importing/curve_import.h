// Hair of other programs as hair groups.
#pragma once

#include "model/importing/curve_fit.h"
#include "model/project/project.h"
#include "model/values/error.h"
#include "model/values/progress.h"

#include <memory>
#include <vector>

namespace hairpaint::model {

/// Reads a file of curves (curve_reader.h), fits them to the head and tells the maps from them: a group for each that
/// the file names; one named after the file where it names none, or more than sixteen. Ids are nobody's yet. Fails
/// where the file can't be read, its hair does not fit on this head, or `progress` cancels. `leftOut`: how
/// many strands were none, of one point or with a point that is no number. Any thread; 100,000 strands
/// of 16 points take some seconds.
[[nodiscard]] Result<std::vector<HairGroup>> groupsFromCurves(const QString& path, const CurveSpaceChoice& choice,
                                                              const std::shared_ptr<const Head>& head,
                                                              const Progress& progress = {},
                                                              std::size_t* leftOut = nullptr);

} // namespace hairpaint::model
