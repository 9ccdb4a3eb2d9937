// A row for each image.
#include "view/dialogs/map_table_dialog.h"

#include "view/look/theme.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace hairpaint::view {

MapTableDialog::MapTableDialog(const std::vector<ImageForMap>& images, const QStringList& groupNames, QWidget* parent)
    : QDialog(parent)
{
    setWindowTitle(tr("Load maps"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(metrics::kPadding);
    auto* table = new QWidget(this);
    auto* grid = new QGridLayout(table);
    grid->setSpacing(metrics::kGap);
    int line = 0;
    for (const ImageForMap& image : images) {
        Row row{.path = image.path};
        auto* name = new QLabel(QFileInfo(image.path).fileName(), table);
        name->setTextFormat(Qt::PlainText);
        row.map = new QComboBox(table);
        row.map->addItem(tr("Left out"));
        for (const model::MapSpec& spec : model::mapSpecs())
            row.map->addItem(spec.titleText(), static_cast<int>(spec.kind));
        row.map->setCurrentIndex(image.map ? row.map->findData(static_cast<int>(*image.map)) : 0);
        row.map->setAccessibleName(tr("Map of %1").arg(name->text()));
        row.group = new QComboBox(table);
        row.group->addItems(groupNames);
        row.group->setCurrentIndex(static_cast<int>(image.group));
        row.group->setAccessibleName(tr("Hair group of %1").arg(name->text()));
        row.group->setVisible(groupNames.size() > 1);
        grid->addWidget(name, line, 0);
        grid->addWidget(row.group, line, 1);
        grid->addWidget(row.map, line++, 2);
        m_rows.push_back(row);
    }
    grid->setRowStretch(line, 1); // Few rows stand together at the top.
    auto* scroll = new QScrollArea(this);
    scroll->setWidget(table);
    scroll->setWidgetResizable(true);
    layout->addWidget(scroll);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Load"));
    buttons->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    layout->addWidget(buttons);
    resize(560, 320);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

std::vector<ImageForMap> MapTableDialog::choice() const
{
    std::vector<ImageForMap> images;
    for (const Row& row : m_rows) {
        const QVariant map = row.map->currentData();
        images.push_back({.path = row.path,
                          .map = map.isValid() ? std::optional(static_cast<model::MapKind>(map.toInt())) : std::nullopt,
                          .group = static_cast<std::size_t>(row.group->currentIndex())});
    }
    return images;
}

} // namespace hairpaint::view
