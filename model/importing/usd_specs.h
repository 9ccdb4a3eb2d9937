// What one layer of USD says of its prims, as it is written: nothing is composed, and no number is read yet.
#pragma once

#include "model/importing/usd_layers.h"
#include "model/values/progress.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace hairpaint::model {

/// The primvars that hair is read from, without "primvars:".
inline constexpr std::array<std::string_view, 7> kHairPrimvars{
    "widths", "width", "displayColor", "groom_width", "groom_color", "groom_guide", "groom_group_id"};

/// What one layer says of an attribute.
struct UsdOpinion
{
    std::string_view value; ///< As it is written; of animated ones the first moment. Empty: not told.
    std::string_view interpolation;
};

/// The arcs of a prim to others that it is made of, from the strongest; variants stand between the first two.
enum class UsdArc : std::uint8_t
{
    Inherits,
    Variant,
    References,
    Payload,
    Specializes
};
inline constexpr std::size_t kUsdArcs = 5;

/// One layer's edit of a list.
struct UsdListEdit
{
    bool isWhole = false; ///< `front` is all; weaker layers' are dropped.
    std::vector<UsdReference> front;
    std::vector<UsdReference> back;
    std::vector<UsdReference> deleted;
};

/// What one layer, or one of its variants, says of a prim.
struct UsdSpec
{
    enum class Specifier : std::uint8_t
    {
        Over,
        Def,
        Class
    };
    using Variants = std::map<std::string_view, std::unique_ptr<UsdSpec>>;

    Specifier specifier = Specifier::Over;
    std::string_view type;
    std::optional<bool> isActive;
    std::map<std::string_view, std::string_view> chosen; ///< By variant set.
    std::array<UsdListEdit, kUsdArcs> arcs;
    std::map<std::string_view, UsdOpinion> attributes; ///< Those that hair is read from.
    std::map<std::string_view, Variants> variantSets;
    std::vector<std::pair<std::string_view, std::unique_ptr<UsdSpec>>> children; ///< As they stand.
    std::map<std::string_view, UsdSpec*> byName;

    [[nodiscard]] UsdSpec& child(std::string_view name); ///< Made where there is none.
};

struct UsdText
{
    UsdLayer source; ///< The others are views of it.
    UsdSpec root;    ///< Its children are the layer's prims.
    double metresPerUnit = 0.01;
    bool isZUp = false;
    std::string_view defaultPrim;
    std::vector<UsdReference> subLayers;
};

enum class UsdScan : std::uint8_t
{
    Whole,
    Broken,
    Stopped
};
/// Into `text`, of whose source all else is read; `prims` counts those of all layers.
[[nodiscard]] UsdScan scanUsd(UsdText& text, const Progress& progress, std::size_t& prims);

} // namespace hairpaint::model
