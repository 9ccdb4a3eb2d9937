// Dialogs over one part of the project: every change is previewed while it moves and one undo step when let go.
#pragma once

#include "view/editing/editor_state.h"
#include "view/widgets/bar_slider.h"
#include "view/widgets/direction_ball.h"

#include <QDialog>

#include <functional>
#include <numbers>
#include <utility>

class QBoxLayout;
class QVBoxLayout;

namespace hairpaint::view {

/// Not modal: a direction ball with a column of controls beside it.
class LiveDialog : public QDialog
{
    Q_OBJECT
protected:
    static constexpr double kPercent = 100.0;
    static constexpr double kDegrees = 180.0 / std::numbers::pi;

    LiveDialog(EditorState& state, const QString& title, DirectionBall* ball, QWidget* parent);

    [[nodiscard]] model::Document& document() const { return m_state.document(); }
    [[nodiscard]] DirectionBall& ball() const { return *m_ball; }
    [[nodiscard]] QBoxLayout& rows() const { return *m_rows; }      ///< The ball's row is the last.
    [[nodiscard]] QVBoxLayout& column() const { return *m_column; } ///< Beside the ball.
    BarSlider* addSlider(const QString& label, double least, double greatest, int decimals, const QString& unit);
    /// On the ball and the sliders of its angles.
    void showDirection(glm::vec3 direction, BarSlider* azimuth, BarSlider* elevation) const;
    /// Updates the controls from the document; called when its values may have changed.
    virtual void follow() = 0;

private:
    EditorState& m_state;
    DirectionBall* m_ball;
    QBoxLayout* m_rows;
    QVBoxLayout* m_column;
};

/// `member`: the part of the project that is edited.
template<typename Value, Value model::Project::*member>
class LiveValueDialog : public LiveDialog
{
protected:
    /// Sets only the value of the control that changed: the numbers of the others are rounded.
    using Edit = std::function<void(Value&)>;

    LiveValueDialog(EditorState& state, const QString& title, QString step, DirectionBall* ball, QWidget* parent)
        : LiveDialog(state, title, ball, parent), m_step(std::move(step))
    {}

    [[nodiscard]] const Value& shown() const { return document().project().*member; }
    void bind(BarSlider* slider, const Edit& edit)
    {
        connect(slider, &BarSlider::valueChanged, this, [this, edit] { preview(edit); });
        connect(slider, &BarSlider::editingFinished, this, [this] {
            m_edit.commit();
            follow(); // Undo may have taken it back meanwhile.
        });
        connect(slider, &BarSlider::editingCancelled, this, [this] { revert(); });
    }
    /// The sliders of its angles follow the ball.
    void bindBall(BarSlider* azimuth, BarSlider* elevation, const Edit& edit)
    {
        connect(&ball(), &DirectionBall::changed, this, [this, azimuth, elevation, edit](glm::vec3 direction) {
            showDirection(direction, azimuth, elevation);
            preview(edit);
        });
        connect(&ball(), &DirectionBall::finished, this, [this, edit] { commit(edit); });
        connect(&ball(), &DirectionBall::cancelled, this, [this] { revert(); });
    }
    void preview(const Edit& edit)
    {
        if (!m_edit.active())
            document().endEdit(); // It may be of the same.
        Value value = document().committed().*member;
        edit(value);
        document().show(m_edit, {.text = m_step}, {.aspect = model::Change::Aspect::Environment},
                        [value](model::Project& project) { project.*member = value; });
    }
    void commit(const Edit& edit)
    {
        preview(edit);
        m_edit.commit();
    }
    virtual void revert()
    {
        m_edit.drop();
        follow();
    }

private:
    QString m_step;
    model::EditSession m_edit;
};

} // namespace hairpaint::view
