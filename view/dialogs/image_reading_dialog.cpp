// Two pictures side by side, a choice below each.
#include "view/dialogs/image_reading_dialog.h"

#include "view/look/theme.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>

namespace hairpaint::view {

ImageReadingDialog::ImageReadingDialog(const QString& imageName, const QString& mapTitle, const ReadingPreview& preview,
                                       QWidget* parent)
    : QDialog(parent)
{
    setWindowTitle(tr("Read the image"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(metrics::kPadding);
    auto* title = new QLabel(tr("What are the pixels of %1 to the map %2?").arg(imageName, mapTitle), this);
    title->setProperty("role", QStringLiteral("title"));
    title->setTextFormat(Qt::PlainText);
    title->setWordWrap(true);
    layout->addWidget(title);
    auto* grid = new QGridLayout;
    grid->setSpacing(metrics::kGap);
    auto* scale = new QRadioButton(tr("&Colours of its scale"), this);
    m_value = new QRadioButton(tr("&Brightness is the value"), this);
    m_value->setChecked(true);
    int column = 0;
    for (const auto& [button, image] : {std::pair(scale, preview.asScale), std::pair(m_value, preview.asValue)}) {
        auto* picture = new QLabel(this);
        picture->setPixmap(QPixmap::fromImage(image));
        picture->setAccessibleName(tr("The map as it would be"));
        grid->addWidget(picture, 0, column);
        grid->addWidget(button, 1, column);
        ++column;
    }
    layout->addLayout(grid);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Load"));
    buttons->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

bool ImageReadingDialog::isValue() const
{
    return m_value->isChecked();
}

} // namespace hairpaint::view
