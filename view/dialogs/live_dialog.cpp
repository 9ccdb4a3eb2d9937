// The layout that the dialogs of wind and light share.
#include "view/dialogs/live_dialog.h"

#include "view/look/theme.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

namespace hairpaint::view {

LiveDialog::LiveDialog(EditorState& state, const QString& title, DirectionBall* ball, QWidget* parent)
    : QDialog(parent), m_state(state), m_ball(ball), m_rows(new QVBoxLayout(this)), m_column(new QVBoxLayout)
{
    setWindowTitle(title);
    setModal(false);
    m_rows->setContentsMargins(metrics::kPadding, metrics::kPadding, metrics::kPadding, metrics::kPadding);
    m_rows->setSpacing(metrics::kGap);
    m_rows->setSizeConstraint(QLayout::SetFixedSize);
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::kPadding);
    row->addWidget(m_ball, 0, Qt::AlignTop);
    m_column->setSpacing(metrics::kGap);
    row->addLayout(m_column, 1);
    m_rows->addLayout(row);
    connect(&document(), &model::Document::changed, this, [this](const model::Change& change) {
        if (change.aspect == model::Change::Aspect::Environment || change.aspect == model::Change::Aspect::Everything)
            follow();
    });
}

BarSlider* LiveDialog::addSlider(const QString& label, double least, double greatest, int decimals, const QString& unit)
{
    constexpr int kWidth = 216;
    auto* slider = new BarSlider(label, this);
    slider->setRange(least, greatest, decimals);
    slider->setUnit(unit);
    slider->setMinimumWidth(kWidth);
    m_column->addWidget(slider);
    return slider;
}

void LiveDialog::showDirection(glm::vec3 direction, BarSlider* azimuth, BarSlider* elevation) const
{
    m_ball->setDirection(direction);
    azimuth->setValue(DirectionBall::azimuthRad(direction) * kDegrees);
    elevation->setValue(DirectionBall::elevationRad(direction) * kDegrees);
}

} // namespace hairpaint::view
