// A haircut's handles: few numbers that make one haircut many.
#pragma once

#include "model/document/document.h"
#include "model/handles/handle_fields.h"
#include "model/tools/strokes/skin_frames.h"

#include <QString>

#include <array>
#include <memory>
#include <optional>
#include <span>

namespace hairpaint::model {

enum class HandleKind : std::uint8_t
{
    Length, ///< Length of all hair: a factor.
    Fringe, ///< Length of the hair over the forehead: a factor.
    Fade,   ///< How much higher the clipped hair at the sides and the back ends, m.
    Part    ///< Where hair is parted: a PartSide.
};
inline constexpr std::size_t kHandleCount = 4;

/// Where hair is parted. Left and right are the head's own.
enum class PartSide : std::uint8_t
{
    AsCombed,
    Left,
    Middle,
    Right
};

/// A row of the table of handles.
struct HandleSpec
{
    HandleKind kind;
    const char* title;                       ///< To be translated in context "HairHandles", as are the next two.
    const char* hint;                        ///< What the handle does.
    const char* step;                        ///< Text of the undo step; %1 is the group's name.
    double least, greatest, usual;           ///< At `usual` the hair is as it was.
    [[nodiscard]] QString titleText() const; ///< Translated.
    [[nodiscard]] QString hintText() const;
};
[[nodiscard]] std::span<const HandleSpec> handleSpecs(); ///< In the order of HandleKind.
[[nodiscard]] const HandleSpec& handleSpec(HandleKind kind);

/// A value for each handle, by HandleKind.
struct HandleValues
{
    std::array<double, kHandleCount> values{1.0, 1.0, 0.0, 0.0};
    [[nodiscard]] double& operator[](HandleKind kind) { return values[static_cast<std::size_t>(kind)]; }
    [[nodiscard]] double operator[](HandleKind kind) const { return values[static_cast<std::size_t>(kind)]; }
    friend bool operator==(const HandleValues&, const HandleValues&) = default;
};

/// What handles change of a group. Edits to the rest of the group are kept.
struct HandledHair
{
    float greatestLengthM = 0.0F;
    float shortestLengthM = 0.0F;
    SharedStack length;
    SharedStack direction;

    [[nodiscard]] static HandledHair of(const HairGroup& group);
    void applyTo(HairGroup& group) const;
    friend bool operator==(const HandledHair&, const HandledHair&) = default;
};

/// The handles of one group, the base, on one head. The group's hair decides which handles it has, so that every style
/// has some, also a user's own and on a foreign head: a fade where sides and back are clipped, fringe and part where
/// hair at the forehead and on top is loose. Fringe, fade and part need a head whose landmarks are known. The result
/// depends on base and values alone. GUI thread.
class HairHandles
{
public:
    /// `density`, `direction`: the group's resolved maps.
    HairHandles(const HairGroup& base, std::shared_ptr<const Head> head, sim::MapRaster density,
                sim::MapRaster direction);
    ~HairHandles();

    [[nodiscard]] bool has(HandleKind kind) const { return m_has[static_cast<std::size_t>(kind)]; }
    /// The base with these values; values beyond a handle's range are clamped.
    [[nodiscard]] HandledHair at(const HandleValues& values);

private:
    void look();
    [[nodiscard]] SharedStack parted(PartSide side);
    [[nodiscard]] LengthFactors factors(const HandleValues& values);

    HairGroup m_base;
    std::shared_ptr<const Head> m_head;
    sim::MapRaster m_density, m_direction, m_length;
    std::array<bool, kHandleCount> m_has{};
    std::unique_ptr<SkinFrames> m_frames;
    std::optional<HandleRegions> m_regions;
    std::optional<FadeColumns> m_columns;
    /// By PartSide: the parted direction map; none until it is asked for.
    std::array<std::optional<SharedStack>, 4> m_parted;
};

} // namespace hairpaint::model
