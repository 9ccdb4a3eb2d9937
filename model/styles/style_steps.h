// How a style was made, for people who want to make it anew: tools on maps, and what was put on, in order.
#pragma once

#include <QString>

#include <cstddef>
#include <vector>

namespace hairpaint::model {

/// A line of it: one tool used so many times in a row on one map, or so many things of one kind put on.
struct StyleStep
{
    QString tool = {}; ///< ToolTraits::name; empty where something was put on.
    QString on = {};   ///< MapSpec::id, and of what was put on WornSpec::id.
    int count = 1;     ///< 1 .. kMostStepUses.
    friend bool operator==(const StyleStep&, const StyleStep&) = default;
};

inline constexpr std::size_t kMostSteps = 256; ///< Steps that a style holds at most.
inline constexpr int kMostStepUses = 100000;

/// Counts the last step once more where it is the same.
void addStep(std::vector<StyleStep>& steps, const QString& tool, const QString& on);

} // namespace hairpaint::model
