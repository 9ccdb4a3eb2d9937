// What a head's skin looks like: a row a tone.
#pragma once

#include <QColor>
#include <QString>

#include <cstddef>
#include <cstdint>
#include <span>

namespace hairpaint::model {

enum class SkinTone : std::uint8_t
{
    Clay, ///< The clay of a display piece instead of skin.
    Porcelain,
    Fair,
    Beige,
    Olive,
    Brown,
    Deep,
    Own ///< The picture that the head's file shows on it; where it shows none, as Clay.
};
inline constexpr std::size_t kSkinToneCount = 8;

struct SkinLook
{
    SkinTone tone;
    const char* id;    ///< Name in files and on the command line.
    const char* title; ///< To be translated in context "SkinTone".
    QRgb skin, lips, lids;
    float scatter; ///< 0..1: how far light spreads within it, red furthest.
    float grain;   ///< 0..1: how deep pores and fine lines are.
    float sheen;   ///< 0..1: how much of the light it reflects without taking its colour.

    [[nodiscard]] QString titleText() const; ///< Translated.
};

[[nodiscard]] std::span<const SkinLook> skinLooks(); ///< In the order of SkinTone.
[[nodiscard]] const SkinLook& skinLook(SkinTone tone);
[[nodiscard]] const SkinLook* findSkinLook(QStringView id); ///< Null where no tone has that id.

} // namespace hairpaint::model
