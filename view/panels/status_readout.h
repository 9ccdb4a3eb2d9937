// The line at the window's foot: hairs, times, the value under the pointer, what the tool does next.
#pragma once

#include "sim/groom/groom.h"
#include "view/editing/editor_state.h"

#include <QTimer>
#include <QWidget>

class QLabel;

namespace hairpaint::view {

/// 24 px high, 11 px text with tabular figures.
class StatusReadout : public QWidget
{
    Q_OBJECT
public:
    explicit StatusReadout(EditorState& state, QWidget* parent = nullptr);

    /// `limit`: what keeps hairs from growing that are painted; it is noted, and explained where the pointer rests.
    void setHairs(qint64 drawn, qint64 all, sim::HairLimit limit = sim::HairLimit::None);
    void setSimulationMs(double milliseconds);
    void setPaused(bool paused); ///< Shown instead of the simulation's time.
    enum class Saved
    {
        NothingToSave, ///< A new project that nobody touched.
        Yes,
        No
    };
    void setSaved(Saved saved);
    [[nodiscard]] QString savedText() const;
    /// Why what is not saved would be lost in a crash, as a clause; empty where it would not.
    void setUnprotected(const QString& reason);
    void setFramesPerSecond(double frames); ///< Zero, where nothing is drawn, shows nothing.
    /// Instead of the tool's hint, for `milliseconds`; errors are marked as such.
    void showMessage(const QString& text, bool error = false, int milliseconds = 6000);

private:
    void follow();
    void followHover();

    EditorState& m_state;
    QLabel* m_hint = nullptr;
    QLabel* m_errorIcon = nullptr;
    QLabel* m_saved = nullptr;
    QLabel* m_value = nullptr;
    QLabel* m_hairs = nullptr;
    QLabel* m_simulation = nullptr;
    QLabel* m_frames = nullptr;
    QTimer m_message;
    bool m_paused = false;
    sim::HairLimit m_limit = sim::HairLimit::None;
    Saved m_savedState = Saved::NothingToSave;
    QString m_unprotected;
};

} // namespace hairpaint::view
