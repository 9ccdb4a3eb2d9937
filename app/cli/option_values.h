// Values of options that several verbs have, read and checked.
#pragma once

#include "sim/motion/neck_motion.h"

#include <QCommandLineParser>
#include <QString>

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>

namespace hairpaint::app {

/// A number in the range of its row among the command's options, the row's standard where it is not given; none (with
/// the usage printed) where it is nonsense.
[[nodiscard]] std::optional<double> numberOption(const QCommandLineParser& parser, const char* command,
                                                 const QString& option);
/// A count, digits alone; `fallback` where it is not given, none likewise.
[[nodiscard]] std::optional<std::int64_t> countOption(const QCommandLineParser& parser, const char* command,
                                                      const QString& option, std::int64_t fallback, std::int64_t most);
/// --wind X,Y,Z in m/s: no value inside where it is not given; none (with the usage printed) where it is nonsense.
[[nodiscard]] std::optional<std::optional<glm::vec3>> windOption(const QCommandLineParser& parser, const char* command);
/// --motion NAME, likewise.
[[nodiscard]] std::optional<std::optional<sim::NeckMotion>> motionOption(const QCommandLineParser& parser,
                                                                         const char* command);
/// --hairs N, likewise.
[[nodiscard]] std::optional<std::optional<std::size_t>> hairsOption(const QCommandLineParser& parser,
                                                                    const char* command);
} // namespace hairpaint::app
