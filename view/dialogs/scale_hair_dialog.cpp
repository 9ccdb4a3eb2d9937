// Percentages of the group's ranges.
#include "view/dialogs/scale_hair_dialog.h"

#include "model/document/hair_scale.h"
#include "model/values/names.h"
#include "view/look/theme.h"
#include "view/widgets/bar_slider.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <cmath>

namespace hairpaint::view {

namespace {

constexpr double kWholePercent = 100.0;

} // namespace

ScaleHairDialog::ScaleHairDialog(EditorState& state, QWidget* parent) : QDialog(parent), m_state(state)
{
    constexpr int kMargin = 16;
    constexpr int kWidth = 360;
    setWindowTitle(tr("Scale the hair"));
    m_state.document().endEdit();
    const model::HairGroup* group = m_state.document().committed().group(m_state.target().group());
    if (group != nullptr) {
        m_group = group->id;
        m_before = group->settings;
        m_step = tr("Scale the hair of \"%1\"").arg(model::shownName(group->name));
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    layout->setSpacing(metrics::kGap);
    auto* remark = new QLabel(tr("All hair of “%1” changes by the same share. The maps stay as they are painted; their "
                                 "ranges change.")
                                  .arg(group != nullptr ? model::shownName(group->name) : QString()),
                              this);
    remark->setTextFormat(Qt::PlainText);
    remark->setWordWrap(true);
    layout->addWidget(remark);
    for (const model::HairScale& scale : model::hairScales()) {
        const model::HairScale::Limits limits = scale.limits(m_before);
        auto* factor = new BarSlider(scale.titleText(), this);
        factor->setRange(std::ceil(limits.least * kWholePercent), std::floor(limits.greatest * kWholePercent));
        factor->setExponent(3.0); // 100 % lies near the middle of 10 to 1,000.
        factor->setUnit(QStringLiteral("%"));
        factor->setDefaultValue(kWholePercent);
        factor->setValue(kWholePercent);
        factor->setEnabled(limits.least < limits.greatest);
        connect(factor, &BarSlider::valueChanged, this, &ScaleHairDialog::preview);
        connect(factor, &BarSlider::editingCancelled, this, &ScaleHairDialog::preview);
        layout->addWidget(factor);
        m_factors.push_back(factor);
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Scale"));
    buttons->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    layout->addSpacing(metrics::kGrid);
    layout->addWidget(buttons);
    setMinimumWidth(kWidth);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void ScaleHairDialog::preview()
{
    sim::GroupSettings settings = m_before;
    for (std::size_t i = 0; i < m_factors.size(); ++i)
        if (m_factors[i]->value() != kWholePercent)
            model::hairScales()[i].apply(settings, m_factors[i]->value() / kWholePercent);
    m_state.document().show(m_edit, {.text = m_step}, {.aspect = model::Change::Aspect::Settings, .group = m_group},
                            [id = m_group, settings](model::Project& project) {
                                if (model::HairGroup* one = project.group(id))
                                    one->settings = settings;
                            });
}

void ScaleHairDialog::accept()
{
    for (BarSlider* factor : m_factors)
        factor->release();
    m_edit.commit();
    QDialog::accept();
}

void ScaleHairDialog::reject()
{
    m_edit.drop();
    QDialog::reject();
}

} // namespace hairpaint::view
