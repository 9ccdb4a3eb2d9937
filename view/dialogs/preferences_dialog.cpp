// The pages of settings, and the general one.
#include "view/dialogs/preferences_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace hairpaint::view {

PreferencesDialog::PreferencesDialog(const Preferences& preferences,
                                     const std::vector<std::pair<QString, QString>>& languages,
                                     std::vector<KeyBinding> bindings, QWidget* parent)
    : QDialog(parent), m_preferences(preferences)
{
    setWindowTitle(tr("Preferences"));
    setModal(false);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::kPadding, metrics::kPadding, metrics::kPadding, metrics::kPadding);
    layout->setSpacing(metrics::kPadding);
    auto* pages = new QTabWidget(this);
    pages->setDocumentMode(true);
    pages->tabBar()->setDrawBase(false);
    pages->addTab(buildGeneral(languages), tr("General"));
    auto* keys = new KeysPage(std::move(bindings), this);
    connect(keys, &KeysPage::keyChanged, this, &PreferencesDialog::keyChanged);
    connect(keys, &KeysPage::keyReset, this, &PreferencesDialog::keyReset);
    pages->addTab(keys, tr("Keys"));
    layout->addWidget(pages);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->button(QDialogButtonBox::Close)->setText(tr("Close"));
    buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
    resize(620, 480);
    setPreferences(preferences);
}

QWidget* PreferencesDialog::buildGeneral(const std::vector<std::pair<QString, QString>>& languages)
{
    auto* page = new QWidget(this);
    page->setObjectName(QStringLiteral("panel"));
    auto* grid = new QGridLayout(page);
    grid->setContentsMargins(metrics::kPadding, 16, metrics::kPadding, metrics::kPadding);
    grid->setHorizontalSpacing(metrics::kPadding);
    grid->setVerticalSpacing(metrics::kGrid);
    grid->setColumnStretch(1, 1);
    m_theme = new QComboBox(page);
    m_theme->addItem(tr("Dark"), static_cast<int>(ThemeKind::Dark));
    m_theme->addItem(tr("Light"), static_cast<int>(ThemeKind::Light));
    m_language = new QComboBox(page);
    m_language->addItem(tr("As the system"), QString());
    for (const auto& [code, name] : languages)
        m_language->addItem(name, code);
    m_presenter = new QComboBox(page);
    m_presenter->addItem(tr("Automatic"), static_cast<int>(PresenterChoice::Automatic));
    m_presenter->addItem(tr("Graphics card (OpenGL)"), static_cast<int>(PresenterChoice::Gl));
    m_presenter->addItem(tr("As a picture (software)"), static_cast<int>(PresenterChoice::Software));
    m_whitePaper = new QCheckBox(tr("White &paper under the maps"), page);
    m_earlierVersions = new QCheckBox(tr("Keep &earlier versions"), page);
    // Each setting with its note close below, and a gap to the next.
    const auto add = [page, grid](const QString& title, QWidget* field, const QString& note) {
        const int row = grid->rowCount();
        if (!title.isEmpty()) {
            auto* label = new QLabel(title, page);
            label->setBuddy(field);
            grid->addWidget(label, row, 0);
        }
        grid->addWidget(field, row, 1);
        if (!note.isEmpty()) {
            auto* label = new QLabel(note, page);
            label->setProperty("role", QStringLiteral("dim"));
            label->setWordWrap(true);
            grid->addWidget(label, row + 1, 1);
        }
        grid->setRowMinimumHeight(row + 2, metrics::kGap);
    };
    add(tr("&Theme"), m_theme, {});
    add(tr("&Language"), m_language, tr("The language changes at the next start."));
    add(tr("3D &area"), m_presenter,
        tr("Automatic takes the graphics card where there is one. A change takes effect at the next start."));
    add({}, m_whitePaper, tr("Maps go from white to their colour instead of from black. Exported images always do."));
    add({}, m_earlierVersions,
        tr("Saving a project leaves the last three beside it, as Name~1, Name~2 and Name~3; 1 is the newest."));
    grid->setRowStretch(grid->rowCount(), 1);
    for (QComboBox* box : {m_theme, m_language, m_presenter})
        connect(box, &QComboBox::currentIndexChanged, this, &PreferencesDialog::readGeneral);
    for (QCheckBox* box : {m_whitePaper, m_earlierVersions})
        connect(box, &QCheckBox::toggled, this, &PreferencesDialog::readGeneral);
    return page;
}

void PreferencesDialog::setPreferences(const Preferences& preferences)
{
    m_filling = true;
    m_preferences = preferences;
    m_theme->setCurrentIndex(m_theme->findData(static_cast<int>(preferences.theme)));
    m_language->setCurrentIndex(std::max(m_language->findData(preferences.language), 0));
    m_presenter->setCurrentIndex(m_presenter->findData(static_cast<int>(preferences.presenter)));
    m_whitePaper->setChecked(preferences.whitePaper);
    m_earlierVersions->setChecked(preferences.earlierVersions);
    m_filling = false;
}

void PreferencesDialog::readGeneral()
{
    if (m_filling)
        return;
    const Preferences chosen{.theme = static_cast<ThemeKind>(m_theme->currentData().toInt()),
                             .language = m_language->currentData().toString(),
                             .presenter = static_cast<PresenterChoice>(m_presenter->currentData().toInt()),
                             .whitePaper = m_whitePaper->isChecked(),
                             .earlierVersions = m_earlierVersions->isChecked()};
    if (chosen == m_preferences)
        return;
    m_preferences = chosen;
    Q_EMIT preferencesChanged(m_preferences);
}

} // namespace hairpaint::view
