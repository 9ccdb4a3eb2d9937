// Two heads from the same side.
#include "view/dialogs/landmarks_dialog.h"

#include "model/files/head_file.h"
#include "view/dialogs/head_side.h"
#include "view/look/theme.h"

#include <QButtonGroup>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace hairpaint::view {

namespace {

struct SideRow
{
    rendering::StandardView side;
    const char* title; ///< To be translated in context "LandmarksDialog".
};
constexpr SideRow kSides[] = {
    {rendering::StandardView::Front, QT_TRANSLATE_NOOP("LandmarksDialog", "Front")},
    {rendering::StandardView::Left, QT_TRANSLATE_NOOP("LandmarksDialog", "Left")},
    {rendering::StandardView::Right, QT_TRANSLATE_NOOP("LandmarksDialog", "Right")},
    {rendering::StandardView::Back, QT_TRANSLATE_NOOP("LandmarksDialog", "Back")},
    {rendering::StandardView::Top, QT_TRANSLATE_NOOP("LandmarksDialog", "Top")},
};

const sim::HeadLandmarks& knownLandmarks()
{
    return *model::defaultHead()->landmarks;
}

/// Each at the nearest point of another head.
sim::HeadLandmarks landmarksNear(const sim::HeadLandmarks& known, const sim::Skin& skin)
{
    sim::HeadLandmarks landmarks = known;
    for (glm::vec3& position : landmarks.positionsHd)
        position = skin.nearest(position).positionHd;
    return landmarks;
}

} // namespace

LandmarksDialog::LandmarksDialog(const std::shared_ptr<const model::Head>& head, QWidget* parent)
    : QDialog(parent), m_known(new HeadSide(model::defaultHead(), knownLandmarks(), this)),
      m_moved(
          new HeadSide(head, head->landmarks ? *head->landmarks : landmarksNear(knownLandmarks(), *head->skin), this))
{
    setWindowTitle(tr("Landmarks"));
    m_moved->setMovable(true);
    m_moved->setObjectName(QStringLiteral("movedLandmarks"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(metrics::kPadding);
    auto* what = new QLabel(head->landmarks
                                ? tr("Hair goes to the same places of the new head. Where a point lies elsewhere than "
                                     "on the left, drag it there.")
                                : tr("No landmarks were found on this head. Drag each point to where it lies on the "
                                     "left; hair goes to the same places."),
                            this);
    what->setWordWrap(true);
    layout->addWidget(what);
    layout->addLayout(buildSides());
    auto* heads = new QHBoxLayout;
    heads->setSpacing(metrics::kPadding);
    heads->addLayout(buildColumn(model::builtInHeads().front().title, m_known), 1);
    heads->addLayout(buildColumn(head->name, m_moved), 1);
    layout->addLayout(heads, 1);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Carry the hair over"));
    m_reset = buttons->addButton(tr("Reset"), QDialogButtonBox::ResetRole);
    m_reset->setEnabled(false);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_moved, &HeadSide::landmarkMoved, this, [this] { m_reset->setEnabled(true); });
    connect(m_reset, &QPushButton::clicked, this, [this, first = m_moved->landmarks()] {
        m_moved->setLandmarks(first);
        m_reset->setEnabled(false);
    });
}

QLayout* LandmarksDialog::buildSides()
{
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::kGrid);
    auto* group = new QButtonGroup(this);
    for (const SideRow& side : kSides) {
        auto* button = new QToolButton(this);
        button->setText(tr(side.title));
        button->setCheckable(true);
        button->setChecked(side.side == rendering::StandardView::Front);
        group->addButton(button);
        row->addWidget(button);
        connect(button, &QToolButton::clicked, this, [this, view = side.side] {
            m_known->setSide(view);
            m_moved->setSide(view);
        });
    }
    row->addStretch(1);
    return row;
}

QLayout* LandmarksDialog::buildColumn(const QString& title, HeadSide* side)
{
    auto* column = new QVBoxLayout;
    column->setSpacing(metrics::kGrid);
    auto* label = new QLabel(title, this);
    label->setTextFormat(Qt::PlainText);
    label->setProperty("role", QStringLiteral("label"));
    column->addWidget(label);
    column->addWidget(side, 1);
    side->setAccessibleName(title);
    return column;
}

const sim::HeadLandmarks& LandmarksDialog::landmarks() const
{
    return m_moved->landmarks();
}

} // namespace hairpaint::view
