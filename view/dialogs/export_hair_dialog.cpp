// Format, program, source, groups, number of hairs, and what the format lets choose.
#include "view/dialogs/export_hair_dialog.h"

#include "model/values/names.h"
#include "view/dialogs/export_option_fields.h"
#include "view/look/theme.h"
#include "view/widgets/bar_slider.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace hairpaint::view {

ExportHairDialog::ExportHairDialog(std::vector<ExportableGroup> groups, const HairExportChoice& before, QWidget* parent)
    : QDialog(parent), m_groups(std::move(groups))
{
    constexpr int kMargin = 16;
    constexpr int kWidth = 420;
    setWindowTitle(tr("Export hair"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    layout->setSpacing(metrics::kPadding);
    m_form = buildForm();
    listGroups();
    layout->addLayout(m_form);
    m_buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_buttons->button(QDialogButtonBox::Ok)->setText(tr("Export…"));
    m_buttons->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    m_buttons->button(QDialogButtonBox::Cancel)->setAutoDefault(false);
    m_buttons->button(QDialogButtonBox::Ok)->setDefault(true);
    m_preview = m_buttons->addButton(tr("Pre&view"), QDialogButtonBox::ActionRole);
    m_preview->setAutoDefault(false); // Enter exports, wherever the focus is.
    m_preview->setToolTip(tr("Shows the cards in the 3D area, and writes nothing."));
    layout->addWidget(m_buttons);
    setMinimumWidth(kWidth);
    fill(before);
    for (QComboBox* box : {m_format, m_target, m_source})
        connect(box, &QComboBox::currentIndexChanged, this, &ExportHairDialog::follow);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &ExportHairDialog::exportWanted);
    connect(m_preview, &QPushButton::clicked, this, &ExportHairDialog::previewWanted);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    follow();
}

ExportHairDialog::~ExportHairDialog() = default;

QComboBox* ExportHairDialog::addChoice(QFormLayout& form, const QString& label)
{
    auto* box = new QComboBox(this);
    form.addRow(label, box);
    return box;
}

QFormLayout* ExportHairDialog::buildForm()
{
    auto* form = new QFormLayout;
    form->setSpacing(metrics::kGap);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_format = addChoice(*form, tr("&Format"));
    for (const model::ExportFormat& format : model::exportFormats())
        m_format->addItem(QStringLiteral("%1 (.%2)").arg(format.titleText(), QLatin1StringView(format.suffix)));
    m_use = new QLabel(this);
    m_use->setProperty("role", QStringLiteral("dim"));
    m_use->setWordWrap(true);
    form->addRow(QString(), m_use);
    m_target = addChoice(*form, tr("&Program"));
    for (const model::ExportTarget& target : model::exportTargets())
        m_target->addItem(target.titleText());
    m_source = addChoice(*form, tr("&Shape"));
    m_source->addItem(tr("As it is now"));
    m_source->addItem(tr("Settled"));
    m_source->addItem(tr("As combed, before it falls"));
    m_list = new QScrollArea(this);
    m_list->setWidgetResizable(true);
    m_list->setFocusPolicy(Qt::NoFocus);
    form->addRow(tr("Groups"), m_list);
    m_hairs = new BarSlider(tr("Hairs"), this);
    m_hairs->setExponent(2.0);
    m_hairs->setHint(tr("An even share of the hairs that are there."));
    form->addRow(m_hairs);
    m_options = std::make_unique<ExportOptionFields>(*form, *this);
    return form;
}

void ExportHairDialog::listGroups()
{
    constexpr int kMostShown = 6;
    m_boxes.clear();
    auto* list = new QWidget;
    auto* rows = new QVBoxLayout(list);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    for (const ExportableGroup& group : m_groups) {
        QString text = model::shownName(group.name);
        auto* box = new QCheckBox(text.replace(QLatin1Char('&'), QLatin1String("&&")), list);
        box->setChecked(!m_leftOut.contains(group.id));
        rows->addWidget(box);
        m_boxes.push_back(box);
        connect(box, &QCheckBox::toggled, this, [this, id = group.id](bool isTaken) {
            if (isTaken)
                m_leftOut.remove(id);
            else
                m_leftOut.insert(id);
            follow();
        });
    }
    m_list->setWidget(list); // Deletes the one before.
    m_list->setFixedHeight(std::min(list->sizeHint().height(), kMostShown * metrics::kRow));
    m_form->setRowVisible(m_list, m_groups.size() > 1);
}

void ExportHairDialog::setGroups(std::vector<ExportableGroup> groups)
{
    if (groups == m_groups)
        return;
    const auto namesOf = [](const std::vector<ExportableGroup>& list) {
        std::vector<std::pair<int, QString>> names;
        names.reserve(list.size());
        for (const ExportableGroup& group : list)
            names.emplace_back(group.id, group.name);
        return names;
    };
    const bool areOthers = namesOf(groups) != namesOf(m_groups);
    m_groups = std::move(groups);
    if (areOthers)
        listGroups();
    follow();
}

void ExportHairDialog::fill(const HairExportChoice& before)
{
    m_format->setCurrentIndex(static_cast<int>(before.request.format - model::exportFormats().data()));
    m_target->setCurrentIndex(static_cast<int>(before.request.target - model::exportTargets().data()));
    m_source->setCurrentIndex(static_cast<int>(before.source));
    m_options->fill(before.request);
    m_hairs->setRange(0.0, 0.0);
}

bool ExportHairDialog::isLeftOut(const ExportableGroup& group) const
{
    return m_groups.size() > 1 && m_leftOut.contains(group.id);
}

std::size_t ExportHairDialog::hairsOfChosen() const
{
    std::size_t hairs = 0;
    for (const ExportableGroup& group : m_groups)
        if (!isLeftOut(group))
            hairs += group.hairs;
    return hairs;
}

void ExportHairDialog::follow()
{
    const model::ExportFormat& format = model::exportFormats()[static_cast<std::size_t>(m_format->currentIndex())];
    // A format that has its own space is the same for every program.
    m_target->setEnabled(format.space != model::FormatSpace::Own);
    m_options->showFor(format);
    const auto hairs = static_cast<double>(hairsOfChosen());
    const bool isPossible = hairs > 0.0 && !(format.isAvatar && !m_avatarProblem.isEmpty());
    m_use->setText(isPossible    ? format.useText()
                   : hairs > 0.0 ? m_avatarProblem
                                 : tr("There are no hairs to be exported here."));
    const bool all = m_hairs->value() >= m_hairs->maximum();
    const double kept = m_hairs->value();
    m_hairs->setRange(std::min(1.0, hairs), hairs);
    m_hairs->setDefaultValue(hairs);
    m_hairs->setValue(all ? hairs : std::min(kept, hairs));
    m_hairs->setEnabled(hairs > 1.0);
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(isPossible);
    m_preview->setVisible(format.hasCards);
    m_preview->setEnabled(hairs > 0.0);
}

void ExportHairDialog::setAvatarProblem(const QString& problem)
{
    m_avatarProblem = problem;
    follow();
}

HairExportChoice ExportHairDialog::choice() const
{
    HairExportChoice choice;
    choice.request.format = &model::exportFormats()[static_cast<std::size_t>(m_format->currentIndex())];
    choice.request.target = &model::exportTargets()[static_cast<std::size_t>(m_target->currentIndex())];
    choice.source = static_cast<HairSource>(m_source->currentIndex());
    model::CurveOptions& curves = choice.request.curves;
    for (const ExportableGroup& group : m_groups)
        if (!isLeftOut(group))
            curves.groups.push_back({.id = group.id, .name = group.name});
    if (m_hairs->value() < m_hairs->maximum())
        curves.hairs = static_cast<std::size_t>(m_hairs->value());
    m_options->put(choice.request);
    return choice;
}

} // namespace hairpaint::view
