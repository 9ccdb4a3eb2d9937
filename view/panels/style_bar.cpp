// Folders and search of the strip: see the header.
#include "view/panels/style_bar.h"

#include "view/look/icons.h"
#include "view/look/theme.h"
#include "view/widgets/bar_slider.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QStyle>
#include <QTabBar>

#include <algorithm>

namespace hairpaint::view {

using model::StyleFolder;

namespace {

constexpr int kSlider = 108;      ///< Width of the slider,
constexpr int kSearch = 152;      ///< Width of the field,
constexpr int kLeastSearch = 104; ///< where there is little room.

} // namespace

StyleBar::StyleBar(QWidget* parent) : QWidget(parent)
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(metrics::kGap, metrics::kGrid, metrics::kGap, 0);
    row->setSpacing(metrics::kGap);
    m_folders = new QTabBar(this);
    m_folders->setObjectName(QStringLiteral("styleFolders"));
    m_folders->setAccessibleName(tr("Folders of styles"));
    m_folders->setDrawBase(false);
    m_folders->setExpanding(false);
    m_folders->setElideMode(Qt::ElideNone);
    m_folders->setFont(themeFont(TextRole::Label));
    for (const StyleFolder& folder : model::styleFolders())
        m_folders->addTab(folder.titleText());
    m_folderBox = new QComboBox(this);
    m_folderBox->setObjectName(QStringLiteral("styleFolderBox"));
    m_folderBox->setAccessibleName(tr("Folders of styles"));
    for (const StyleFolder& folder : model::styleFolders())
        m_folderBox->addItem(folder.titleText());
    m_folderBox->hide();
    m_part = new QComboBox(this);
    m_part->setObjectName(QStringLiteral("stylePart"));
    m_part->setAccessibleName(tr("What is taken of a style"));
    m_part->setToolTip(tr("What pointing at a style shows and clicking takes; the rest of your hair stays"));
    for (const model::StylePartSpec& spec : model::styleParts())
        m_part->addItem(spec.part == model::StylePart::All ? tr("Whole style") : spec.titleText());
    m_fraction = new BarSlider(tr("Mix"), this);
    m_fraction->setObjectName(QStringLiteral("styleFraction"));
    m_fraction->setRange(0.0, 100.0);
    m_fraction->setUnit(QStringLiteral("%"));
    m_fraction->setDefaultValue(100.0);
    m_fraction->setValue(100.0);
    m_fraction->setPreferredWidth(kSlider);
    m_fraction->setHint(
        tr("How much of a style is taken; below 100% it is mixed with the hair that was there. Ties and "
           "braids, which can't be mixed, come with 50% and more"));
    m_search = new QLineEdit(this);
    m_search->setObjectName(QStringLiteral("styleSearch"));
    m_search->setPlaceholderText(tr("Find a style"));
    m_search->setAccessibleName(tr("Find a style"));
    m_search->setClearButtonEnabled(true);
    m_search->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
    m_search->setMinimumWidth(kLeastSearch);
    m_search->setMaximumWidth(kSearch);
    row->addWidget(m_folders, 1);
    row->addWidget(m_folderBox);
    row->addWidget(m_part);
    row->addWidget(m_fraction);
    row->addWidget(m_search);
    for (QWidget* one : std::initializer_list<QWidget*>{m_folders, m_search})
        one->installEventFilter(this);
    connect(m_fraction, &BarSlider::valueChanged, this, &StyleBar::fractionMoved);
    connect(m_fraction, &BarSlider::editingFinished, this, &StyleBar::fractionSet);
    connect(m_fraction, &BarSlider::editingCancelled, this, &StyleBar::fractionTakenBack);
    connect(m_folders, &QTabBar::currentChanged, m_folderBox, &QComboBox::setCurrentIndex);
    connect(m_folderBox, &QComboBox::currentIndexChanged, m_folders, &QTabBar::setCurrentIndex);
    connect(m_folders, &QTabBar::currentChanged, this, &StyleBar::filterChanged);
    connect(m_search, &QLineEdit::textChanged, this, &StyleBar::filterChanged);
    connect(m_part, &QComboBox::currentIndexChanged, this, [this](int index) {
        m_part->setProperty("narrowed", index > 0); // Seen, since it lasts.
        m_part->style()->polish(m_part);
        Q_EMIT partChosen();
    });
}

const StyleFolder& StyleBar::folder() const
{
    return model::styleFolders()[static_cast<std::size_t>(std::max(m_folders->currentIndex(), 0))];
}

QString StyleBar::words() const
{
    return m_search->text().simplified();
}

model::StylePart StyleBar::part() const
{
    return model::styleParts()[static_cast<std::size_t>(std::max(m_part->currentIndex(), 0))].part;
}

double StyleBar::fraction() const
{
    return m_fraction->value() / 100.0;
}

void StyleBar::widen()
{
    if (folder().kind == StyleFolder::Kind::All)
        m_search->clear();
    else
        m_folders->setCurrentIndex(0);
}

void StyleBar::startSearch()
{
    m_search->setFocus(Qt::ShortcutFocusReason);
    m_search->selectAll();
}

void StyleBar::takeKeys()
{
    QWidget* const shown = m_folders->isHidden() ? static_cast<QWidget*>(m_folderBox) : m_folders;
    shown->setFocus(Qt::ShortcutFocusReason);
}

void StyleBar::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    const int room =
        width() - 5 * metrics::kGap - m_part->sizeHint().width() - m_fraction->sizeHint().width() - kLeastSearch;
    const bool isRoomy = m_folders->sizeHint().width() <= room;
    m_folders->setVisible(isRoomy);
    m_folderBox->setVisible(!isRoomy);
}

bool StyleBar::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::KeyPress)
        return QWidget::eventFilter(watched, event);
    switch (static_cast<QKeyEvent*>(event)->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Down:
        Q_EMIT downWanted();
        return true;
    case Qt::Key_Escape:
        if (watched == m_search && !m_search->text().isEmpty()) {
            m_search->clear();
            return true;
        }
        break;
    default:
        break;
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace hairpaint::view
