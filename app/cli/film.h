// Frames of hair in motion, for verbs that write one file a frame.
#pragma once

#include <QCommandLineParser>
#include <QString>

#include <tl/expected.hpp>

namespace hairpaint::app {

struct Film
{
    int first = 0;
    int last = -1; ///< Below the first: no film.
    double framesPerSecond = 30.0;
    [[nodiscard]] bool wanted() const { return last >= first; }
};

/// --frames A-B, without the rate; the problem in words.
[[nodiscard]] tl::expected<Film, QString> framesOption(const QCommandLineParser& parser);
/// "FILE.0001.png" for "FILE.png".
[[nodiscard]] QString framePath(const QString& output, int number);
/// Time from the frame before to frame `number`, in whole steps of the simulation. They are counted from frame 0, so
/// that rounding errors do not accumulate.
[[nodiscard]] double secondsBefore(int number, double framesPerSecond);

} // namespace hairpaint::app
