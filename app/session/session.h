// Connects document, editor, simulation and views; nothing else does.
#pragma once

#include "model/document/document.h"
#include "model/maps/map_colours.h"
#include "sim/motion/simulation_worker.h"
#include "view/editing/editor_state.h"

#include <QObject>
#include <QTimer>

#include <atomic>
#include <map>

namespace hairpaint::app {

/// Owns what outlives every view: the document, what the user works with, and the simulation. GUI thread.
///
/// Document changes are gathered until the event loop is idle, then one snapshot goes to the worker (latest wins); its
/// frames come back likewise.
class Session : public QObject
{
    Q_OBJECT
public:
    explicit Session(model::Project project, QObject* parent = nullptr);
    ~Session() override;

    [[nodiscard]] model::Document& document() { return m_document; }
    [[nodiscard]] view::EditorState& editor() { return m_editor; }
    [[nodiscard]] const std::shared_ptr<const sim::StrandFrame>& frame() const { return m_frame; }
    [[nodiscard]] bool paused() const { return m_paused; }
    /// Whether no other frame will come until something changes.
    [[nodiscard]] bool resting() const;

    enum class Hair : std::uint8_t
    {
        Underway, ///< frame() shows something older, or something that is no part of the document.
        Current,  ///< frame() is the hair of the document as it is.
        Failed    ///< There was no memory for it.
    };
    [[nodiscard]] Hair hair() const;
    /// Call before computing from the hair: commits a stroke and drops previews. Its frame follows soon.
    void endPreviews();

    /// Shows the hair in the colours of that map; none shows its own colours again. No undo step; the motion goes on.
    void lookAt(std::optional<model::MapKind> map);
    /// Tells how long the 3D area took to draw a frame of moving hair: no more frames are made than it can draw.
    void setDrawTime(double milliseconds);
    /// Tells that hairs with StrandStyle::detail below `detail` are drawn: while hair moves, no others get positions.
    void setDrawnDetail(float detail);
    /// While the returned object exists, frames contain every hair, and hair() waits for such a frame.
    [[nodiscard]] std::shared_ptr<const void> wholeHair();

public Q_SLOTS:
    void setPaused(bool paused);
    void resetHair();
    void puff(glm::vec3 centreWo, glm::vec3 velocity, float radiusM);
    void setPose(const hairpaint::sim::HeadPose& pose);
    /// Previews while `done` is false, then one undo step.
    void changeLight(const hairpaint::model::LightSettings& light, bool done);
    void changeWind(const hairpaint::sim::Wind& wind, bool done);
    void toggleWind();

Q_SIGNALS:
    void frameChanged(const std::shared_ptr<const hairpaint::sim::StrandFrame>& frame);
    void pausedChanged(bool paused);
    /// The newest content could not be made into hair: one sentence. The last frame stays.
    void hairFailed(const QString& reason);

private:
    void onChanged(const model::Change& change);
    void sendInput();
    void tellDetail();
    void takeFrame();

    model::Document m_document;
    view::EditorState m_editor;
    model::EditSession m_lightEdit, m_windEdit; ///< What keys and drags change until they are done.
    std::shared_ptr<const sim::StrandFrame> m_frame;
    QTimer m_inputTimer; ///< Its interval is 0: it fires when the event loop is idle.
    std::atomic<bool> m_frameAnnounced = false;
    bool m_paused = false;
    std::uint64_t m_sentRevision = 0;
    std::optional<std::uint64_t> m_failedRevision;
    std::optional<model::MapKind> m_looked;
    std::map<model::Id, model::MapColours> m_colours; ///< By group: the colours of the map that is looked at.
    double m_drawMs = 0.0;                            ///< Time to draw a frame, smoothed.
    double m_frameRate = 0.0;                         ///< The frame rate that the worker was told last.
    float m_drawnDetail = 1.0F;
    float m_frameDetail = 1.0F; ///< The drawn detail that the worker was told last.
    std::weak_ptr<const void> m_wholeHair;
    std::shared_ptr<const void> m_hairOfTool; ///< Set while a tool may cut hair: unpositioned hair would stay uncut.
    std::unique_ptr<sim::SimulationWorker> m_worker; ///< Last: it calls back until it is gone.
};

} // namespace hairpaint::app
