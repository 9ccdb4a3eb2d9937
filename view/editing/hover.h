// The point under the pointer, as both areas show it.
#pragma once

#include "model/tools/tool.h"

#include <QObject>

#include <optional>
#include <vector>

namespace hairpaint::view {

class EditTarget;
class ToolBox;
class ViewOptions;

struct HoverPoint
{
    model::Area area = model::Area::Paint;
    glm::vec2 uv{0.0F};
    std::optional<sim::SurfacePoint> point = {};
    std::optional<model::OverHair> hair =
        {}; ///< Where the tool works on the strands that are seen there; no point then.
    float pixelM = model::ToolEvent{}.pixelM;
};

/// GUI thread; what it is made of must outlive it.
class Hover : public QObject
{
    Q_OBJECT
public:
    Hover(const EditTarget& target, ToolBox& tools, const ViewOptions& options, QObject* parent = nullptr);

    /// None while the pointer is over neither area.
    [[nodiscard]] const std::optional<HoverPoint>& at() const { return m_at; }
    /// Also passed to a tool with pending input.
    void set(const std::optional<HoverPoint>& at);
    /// Where both areas draw the brush's rings: under the pointer, and the mirrored twin if there is one. Empty off the
    /// skin, over strands that the tool works on, and where the active tool has no ring.
    [[nodiscard]] std::vector<sim::SurfacePoint> ringPoints() const;

Q_SIGNALS:
    void changed();

private:
    const EditTarget& m_target;
    ToolBox& m_tools;
    const ViewOptions& m_options;
    std::optional<HoverPoint> m_at;
};

} // namespace hairpaint::view
