// The program's own settings: look, language, how the 3D area is shown, keys.
#pragma once

#include "view/dialogs/keys_page.h"
#include "view/head_area/presenter_choice.h"
#include "view/look/theme.h"

#include <QDialog>

#include <vector>

class QCheckBox;
class QComboBox;

namespace hairpaint::view {

struct Preferences
{
    ThemeKind theme = ThemeKind::Dark;
    QString language; ///< "de"; empty: the system's.
    PresenterChoice presenter = PresenterChoice::Automatic;
    bool whitePaper = false;
    bool earlierVersions = false; ///< Saving keeps the last three beside the file.
    friend bool operator==(const Preferences&, const Preferences&) = default;
};

/// Not modal; changes take effect at once.
class PreferencesDialog : public QDialog
{
    Q_OBJECT
public:
    /// `languages`: code and own name, "de" and "Deutsch".
    PreferencesDialog(const Preferences& preferences, const std::vector<std::pair<QString, QString>>& languages,
                      std::vector<KeyBinding> bindings, QWidget* parent = nullptr);
    [[nodiscard]] const Preferences& preferences() const { return m_preferences; }
    void setPreferences(const Preferences& preferences); ///< Emits no signal.

Q_SIGNALS:
    void preferencesChanged(const hairpaint::view::Preferences& preferences);
    /// As the page of keys says.
    void keyChanged(QAction* action, const QKeySequence& key);
    void keyReset(QAction* action);

private:
    [[nodiscard]] QWidget* buildGeneral(const std::vector<std::pair<QString, QString>>& languages);
    void readGeneral();

    Preferences m_preferences;
    QComboBox* m_theme = nullptr;
    QComboBox* m_language = nullptr;
    QComboBox* m_presenter = nullptr;
    QCheckBox* m_whitePaper = nullptr;
    QCheckBox* m_earlierVersions = nullptr;
    bool m_filling = false;
};

} // namespace hairpaint::view
