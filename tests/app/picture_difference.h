// How far two pictures of the same size differ.
#pragma once

#include <QImage>

#include <cstdlib>

namespace hairpaint::test {

/// Mean absolute difference over all pixels and channels, 0..255.
inline double meanDifference(const QImage& a, const QImage& b)
{
    double sum = 0.0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb here = a.pixel(x, y);
            const QRgb there = b.pixel(x, y);
            sum += std::abs(qRed(here) - qRed(there)) + std::abs(qGreen(here) - qGreen(there)) +
                   std::abs(qBlue(here) - qBlue(there));
        }
    return sum / (3.0 * a.width() * a.height());
}

} // namespace hairpaint::test
