// A style's card: see the header.
#include "view/dialogs/style_card.h"

#include "view/look/theme.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace hairpaint::view {

StyleCard::StyleCard(const QString& name, bool isForeignHead, QWidget* parent) : QDialog(parent)
{
    setObjectName(QStringLiteral("styleCard"));
    setWindowTitle(tr("About '%1'").arg(name));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 20, 20, 16);
    column->setSpacing(metrics::kPadding);
    auto* title = new QLabel(name, this);
    title->setProperty("role", QLatin1String("title"));
    column->addWidget(title);
    auto* pictures = new QHBoxLayout;
    pictures->setSpacing(metrics::kGap);
    const std::array titles{tr("Front"), tr("Left"), tr("Right"), tr("Back")};
    for (std::size_t i = 0; i < kPictures; ++i) {
        auto* one = new QVBoxLayout;
        one->setSpacing(metrics::kGrid);
        m_pictures.at(i) = new QLabel(tr("Drawing…"), this);
        m_pictures.at(i)->setObjectName(QStringLiteral("styleView"));
        m_pictures.at(i)->setProperty("role", QLatin1String("dim"));
        m_pictures.at(i)->setAlignment(Qt::AlignCenter);
        m_pictures.at(i)->setFrameShape(QFrame::StyledPanel);
        m_pictures.at(i)->setFixedSize(kPictureSide, kPictureSide);
        m_pictures.at(i)->setAccessibleName(tr("%1, %2").arg(name, titles.at(i)));
        auto* caption = new QLabel(titles.at(i), this);
        caption->setProperty("role", QLatin1String("dim"));
        caption->setAlignment(Qt::AlignHCenter);
        one->addWidget(m_pictures.at(i));
        one->addWidget(caption);
        pictures->addLayout(one);
    }
    column->addLayout(pictures);
    m_progress = new QProgressBar(this);
    m_progress->setRange(0, static_cast<int>(kPictures) + 1);
    m_progress->setValue(0);
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(4);
    m_progress->setAccessibleName(tr("How much of the card is there"));
    column->addWidget(m_progress);
    m_facts = new QFormLayout;
    m_facts->setLabelAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_facts->setHorizontalSpacing(metrics::kPadding);
    m_facts->setVerticalSpacing(metrics::kGrid);
    column->addLayout(m_facts);
    m_problem = new QLabel(this);
    m_problem->setProperty("role", QLatin1String("error"));
    m_problem->setWordWrap(true);
    m_problem->hide();
    column->addWidget(m_problem);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->button(QDialogButtonBox::Close)->setText(tr("Close"));
    QPushButton* putOn = buttons->addButton(tr("Make it on my head"), QDialogButtonBox::AcceptRole);
    putOn->setObjectName(QStringLiteral("stylePutOn"));
    putOn->setDefault(true);
    if (isForeignHead) {
        // Styles are carried by them, so a style that sits askew is mended there.
        QPushButton* landmarks = buttons->addButton(tr("Landmarks of my head…"), QDialogButtonBox::ActionRole);
        landmarks->setObjectName(QStringLiteral("styleLandmarks"));
        landmarks->setToolTip(tr("Hairline, crown, ears: by them the style is laid on your head"));
        connect(landmarks, &QPushButton::clicked, this, &StyleCard::landmarksWanted);
    }
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        Q_EMIT putOnWanted();
        accept();
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(buttons);
}

void StyleCard::setPicture(std::size_t index, const QImage& picture)
{
    QImage shown = picture;
    shown.setDevicePixelRatio(picture.width() / static_cast<double>(kPictureSide));
    m_pictures.at(index)->setPixmap(QPixmap::fromImage(shown));
    m_progress->setValue(m_progress->value() + 1);
    m_progress->setVisible(m_progress->value() < m_progress->maximum());
}

void StyleCard::addFacts(const std::vector<std::pair<QString, QString>>& facts)
{
    for (const auto& [what, value] : facts) {
        auto* name = new QLabel(what, this);
        name->setProperty("role", QLatin1String("dim"));
        auto* text = new QLabel(value, this);
        text->setWordWrap(true);
        text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        text->setAccessibleName(what);
        m_facts->addRow(name, text);
    }
    m_progress->setValue(m_progress->value() + 1);
}

void StyleCard::tellProblem(const QString& problem)
{
    m_progress->hide();
    for (QLabel* picture : m_pictures)
        if (picture->pixmap().isNull())
            picture->setText(QStringLiteral("–"));
    m_problem->setText(problem);
    m_problem->setVisible(!problem.isEmpty());
}

} // namespace hairpaint::view
