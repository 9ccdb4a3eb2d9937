// A user at work: the tools of the program played over the head of new projects, as the window plays the mouse.
#pragma once

#include "model/document/command_ptr.h"
#include "model/styles/preset.h"
#include "model/tools/strokes/selection.h"
#include "model/tools/tool.h"
#include "model/tools/tool_list.h"

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace hairpaint::presets {

using model::MapKind;
using model::PaintValue;

/// Where the axis is around which Recording::around() looks at the head, forward of its middle.
inline constexpr float kAxisForwardM = -0.010F;

/// The ring of a brush or a comb.
struct Ring
{
    float sizeM = 0.03F; ///< Diameter on the skin.
    float hardness = 0.6F;
    float opacity = 1.0F;
};

struct Parting
{
    float reachM = 0.1F;
    float flatness = 0.9F;
    float gapM = 0.0F; ///< Hairs that lie to both sides leave a line of skin of their own.
};

/// A stroke along a height of the head, with what it leaves there.
struct Band
{
    float heightM;
    PaintValue value;
};

[[nodiscard]] PaintValue scalar(float value);
[[nodiscard]] PaintValue colour(QRgb value);
[[nodiscard]] PaintValue entry(int index); ///< An entry of a palette: of braids, or of what is worn.
[[nodiscard]] PaintValue upright();        ///< The direction map's value of hair that stands upright.

/// What Hair > Add hair group adds of that kind (model/styles/hair_kinds.h) to the head of new projects.
[[nodiscard]] model::HairGroup grownHair(QLatin1StringView kind);

/// Points are Hd, m: a user finds them by eye. Every action is one step of the document's undo. One thread.
class Recording
{
public:
    using Points = std::vector<sim::SurfacePoint>;

    /// A new project with `grown` for its only group, and the maps at the styles' size.
    Recording(model::HairGroup grown, const sim::GroupSettings& settings);

    [[nodiscard]] model::Preset preset(const QString& name) const;
    /// Number of actions asked for.
    [[nodiscard]] int actions() const { return m_actions; }
    [[nodiscard]] model::Document& document() { return m_document; }

    /// The skin as it is seen from the side on which it lies: 0 degrees in front, 90 at the head's left, 180 behind.
    struct Seen
    {
        float degrees, heightM;
    };
    [[nodiscard]] sim::SurfacePoint around(float degrees, float heightM) const;
    [[nodiscard]] Points along(std::span<const Seen> line) const;
    /// The skin as it is seen from above.
    [[nodiscard]] sim::SurfacePoint above(float leftM, float forwardM) const;
    /// The skin as it is seen from a point within the head.
    [[nodiscard]] sim::SurfacePoint outward(glm::vec3 fromHd, glm::vec3 directionHd) const;
    /// Along a height, from the face to the back of the head unless told otherwise.
    [[nodiscard]] Points level(float heightM, float fromDegrees = 0.0F, float toDegrees = 180.0F) const;
    /// Over the middle of the head, from the forehead to the nape, or to one side of it.
    [[nodiscard]] Points overHead(float leftM, float fromForwardM, float toForwardM) const;

    [[nodiscard]] PaintValue length(float lengthM) const; ///< The length map's value of that length.

    void setMirror(bool mirror) { m_mirror = mirror; }
    void setLayerOpacity(MapKind map, float opacity);
    /// Adds a layer, which is painted on from now on.
    void addLayer(MapKind map, model::BlendMode blend);

    void fill(MapKind map, const PaintValue& value); ///< Fills all of the map.
    void brush(MapKind map, const PaintValue& value, const Ring& ring, const Points& points);
    void erase(MapKind map, const Ring& ring, const Points& points);
    /// A soft stroke along each height, wide enough to lead from one value to the next.
    void bands(MapKind map, const std::vector<Band>& bands, float fromDegrees = 0.0F, float toDegrees = 180.0F);
    /// Fills what a freehand line goes around.
    void polygon(MapKind map, const PaintValue& value, const Points& outline);
    /// A filled rectangle on the layout.
    void rectangle(MapKind map, const PaintValue& value, glm::vec2 fromUv, glm::vec2 toUv);
    /// Lays hair along the points.
    void comb(float flatness, const Ring& ring, const Points& points);
    /// A click at each point, then Enter.
    void part(const Parting& parting, const Points& points);
    /// Hair that nothing gathers yet goes through a tie there; where hair there is gathered, its tie goes there.
    void gather(model::WornKind kind, const sim::SurfacePoint& point);
    void wear(model::WornKind kind, const sim::SurfacePoint& point);
    /// In the panel of what is worn, on everything of that kind.
    void setWorn(model::WornKind kind, const std::function<void(model::Worn&)>& set);

private:
    [[nodiscard]] const model::HairGroup& group() const;
    [[nodiscard]] model::ToolContext context(MapKind map);
    [[nodiscard]] model::Tool& tool(model::ToolId id);
    void push(model::CommandPtr command);
    void tell(model::ToolId id, MapKind map); ///< Adds a use of that tool to the steps.
    void use(const Ring& ring);
    void click(model::ToolId id, MapKind map, const sim::SurfacePoint& point);
    /// From point to point along a smooth curve over the skin, as a hand would.
    void drag(model::ToolId id, MapKind map, const Points& points);
    [[nodiscard]] model::ToolEvent eventAt(const sim::SurfacePoint& point) const;

    model::Document m_document;
    std::vector<std::unique_ptr<model::Tool>> m_tools = model::makeTools();
    model::ToolSettings m_settings;
    model::Selection m_selection;
    bool m_mirror = true;
    double m_seconds = 0.0;
    int m_actions = 0;
    std::vector<model::StyleStep> m_steps;
};

} // namespace hairpaint::presets
