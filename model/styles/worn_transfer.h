// Worn things carried from head to head.
#pragma once

#include "model/project/project.h"

#include <memory>
#include <vector>

namespace hairpaint::model {

/// What is worn, on another head: the points of the skin that things hang on go where the warp that brings the heads
/// together by their landmarks takes them (as styles go, style_transfer.h), and things keep their size, their offset
/// and how they are turned there. Those that a head brings stay as they are; so do all where the heads have no
/// landmarks, and hang on what skin is nearest then. Any thread.
[[nodiscard]] std::vector<Worn> carriedWorn(std::vector<Worn> worn, const std::shared_ptr<const Head>& from,
                                            const std::shared_ptr<const Head>& to);

} // namespace hairpaint::model
