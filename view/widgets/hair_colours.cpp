// The colours that hair is sold in.
#include "view/widgets/hair_colours.h"

#include <QCoreApplication>

namespace hairpaint::view {

namespace {

constexpr HairColour kNatural[] = {
    {QT_TRANSLATE_NOOP("HairColours", "1 Black"), 0xFF14100F},
    {QT_TRANSLATE_NOOP("HairColours", "2 Darkest brown"), 0xFF211712},
    {QT_TRANSLATE_NOOP("HairColours", "3 Dark brown"), 0xFF322116},
    {QT_TRANSLATE_NOOP("HairColours", "4 Medium brown"), 0xFF452C1B},
    {QT_TRANSLATE_NOOP("HairColours", "5 Light brown"), 0xFF5A3822},
    {QT_TRANSLATE_NOOP("HairColours", "6 Dark blonde"), 0xFF765030},
    {QT_TRANSLATE_NOOP("HairColours", "7 Medium blonde"), 0xFF956B3F},
    {QT_TRANSLATE_NOOP("HairColours", "8 Light blonde"), 0xFFB38A55},
    {QT_TRANSLATE_NOOP("HairColours", "9 Very light blonde"), 0xFFCFAB75},
    {QT_TRANSLATE_NOOP("HairColours", "10 Lightest blonde"), 0xFFE4CB9E},
};
constexpr HairColour kRedAndGrey[] = {
    {QT_TRANSLATE_NOOP("HairColours", "Mahogany"), 0xFF3F1714},
    {QT_TRANSLATE_NOOP("HairColours", "Auburn"), 0xFF5E2417},
    {QT_TRANSLATE_NOOP("HairColours", "Chestnut"), 0xFF71371D},
    {QT_TRANSLATE_NOOP("HairColours", "Copper"), 0xFF9A4A1E},
    {QT_TRANSLATE_NOOP("HairColours", "Ginger"), 0xFFB8662C},
    {QT_TRANSLATE_NOOP("HairColours", "Strawberry blonde"), 0xFFC98F5D},
    {QT_TRANSLATE_NOOP("HairColours", "Steel grey"), 0xFF565656},
    {QT_TRANSLATE_NOOP("HairColours", "Salt and pepper"), 0xFF85827E},
    {QT_TRANSLATE_NOOP("HairColours", "Silver"), 0xFFB5B3B0},
    {QT_TRANSLATE_NOOP("HairColours", "White"), 0xFFE9E6E0},
};
constexpr HairColour kFashion[] = {
    {QT_TRANSLATE_NOOP("HairColours", "Burgundy"), 0xFF6A1230},
    {QT_TRANSLATE_NOOP("HairColours", "Cherry red"), 0xFFB3182B},
    {QT_TRANSLATE_NOOP("HairColours", "Coral"), 0xFFE8694F},
    {QT_TRANSLATE_NOOP("HairColours", "Rose"), 0xFFE48BA8},
    {QT_TRANSLATE_NOOP("HairColours", "Magenta"), 0xFFC32B8D},
    {QT_TRANSLATE_NOOP("HairColours", "Lilac"), 0xFFA98BD0},
    {QT_TRANSLATE_NOOP("HairColours", "Violet"), 0xFF5B2E91},
    {QT_TRANSLATE_NOOP("HairColours", "Midnight blue"), 0xFF1D2A5B},
    {QT_TRANSLATE_NOOP("HairColours", "Turquoise"), 0xFF1E9C9A},
    {QT_TRANSLATE_NOOP("HairColours", "Mint"), 0xFF8FD3AE},
};

} // namespace

std::span<const HairColour> naturalHairColours()
{
    return kNatural;
}

std::span<const HairColour> redAndGreyHairColours()
{
    return kRedAndGrey;
}

std::span<const HairColour> fashionHairColours()
{
    return kFashion;
}

QString hairColourName(const HairColour& colour)
{
    return QCoreApplication::translate("HairColours", colour.name);
}

} // namespace hairpaint::view
