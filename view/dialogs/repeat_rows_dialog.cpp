// One number, shown at once.
#include "view/dialogs/repeat_rows_dialog.h"

#include "view/look/theme.h"
#include "view/widgets/bar_slider.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <cmath>

namespace hairpaint::view {

namespace {

model::ToolContext contextOf(EditorState& state, model::ToolSettings& settings)
{
    const model::LayerAddress target{.group = state.target().group(),
                                     .map = model::MapKind::Braid,
                                     .layer = state.target().layer(model::MapKind::Braid)};
    return {.document = state.document(),
            .target = target,
            .settings = settings,
            .selection = state.tools().selection(),
            .mirror = state.options().mirror()};
}

} // namespace

RepeatRowsDialog::RepeatRowsDialog(EditorState& state, QWidget* parent)
    : QDialog(parent), m_settings(state.tools().settings()),
      m_repeat(contextOf(state, m_settings), tr("Repeat between two rows"))
{
    constexpr int kMargin = 16;
    constexpr int kWidth = 360;
    setWindowTitle(tr("Repeat between two rows"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    layout->setSpacing(metrics::kGap);
    auto* remark = new QLabel(tr("Cornrows are painted between the two that were painted last, or the two that reach "
                                 "into the selection."),
                              this);
    remark->setTextFormat(Qt::PlainText);
    remark->setWordWrap(true);
    layout->addWidget(remark);
    m_count = new BarSlider(tr("Rows between"), this);
    m_count->setRange(1.0, model::kMostRowsBetween);
    m_count->setDefaultValue(m_repeat.fittingCount());
    m_count->setValue(m_repeat.fittingCount());
    connect(m_count, &BarSlider::valueChanged, this, &RepeatRowsDialog::preview);
    connect(m_count, &BarSlider::editingCancelled, this, &RepeatRowsDialog::preview);
    layout->addWidget(m_count);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Repeat"));
    buttons->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    layout->addSpacing(metrics::kGrid);
    layout->addWidget(buttons);
    setMinimumWidth(kWidth);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    preview();
}

void RepeatRowsDialog::preview()
{
    m_repeat.show(static_cast<int>(std::lround(m_count->value())));
}

void RepeatRowsDialog::accept()
{
    m_count->release();
    m_repeat.commit();
    QDialog::accept();
}

void RepeatRowsDialog::reject()
{
    m_repeat.cancel();
    QDialog::reject();
}

} // namespace hairpaint::view
