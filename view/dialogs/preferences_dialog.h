// The program's own settings: look, language, how the 3D area is shown, keys.
#pragma once

#include "view/presenter_choice.h"
#include "view/theme.h"

#include <QAction>
#include <QDialog>
#include <QKeySequence>
#include <QList>

#include <vector>

class QCheckBox;
class QComboBox;
class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace hairpaint::view {

struct Preferences
{
    ThemeKind theme = ThemeKind::Dark;
    QString language; ///< "de"; empty: the system's.
    PresenterChoice presenter = PresenterChoice::Automatic;
    bool whitePaper = false;
    friend bool operator==(const Preferences&, const Preferences&) = default;
};

/// An action whose key can be changed.
struct KeyBinding
{
    QAction* action = nullptr;       ///< Not owned; its shortcut is shown.
    QString section;                 ///< "File"
    QString name;                    ///< "Undo": the menu's words without marks, and without what changes in them.
    QList<QKeySequence> defaultKeys; ///< The first one is listed; none: it has no key of its own.
    [[nodiscard]] QKeySequence defaultKey() const { return defaultKeys.value(0); }
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
    void setPreferences(const Preferences& preferences); ///< Tells nothing.

Q_SIGNALS:
    void preferencesChanged(const hairpaint::view::Preferences& preferences);
    /// The dialog set it on the action already; the application remembers it.
    void keyChanged(QAction* action, const QKeySequence& key);
    /// It has its own keys again; the application forgets what it remembered.
    void keyReset(QAction* action);

private:
    [[nodiscard]] QWidget* buildGeneral(const std::vector<std::pair<QString, QString>>& languages);
    [[nodiscard]] QWidget* buildKeys();
    void readGeneral();
    void fillKeys();
    void filterKeys(const QString& text);
    void followKey();
    void setKey(int binding, const QKeySequence& key);
    void resetKey(int binding);
    void resetAllKeys();
    void put(int binding, const QList<QKeySequence>& keys);
    [[nodiscard]] int currentBinding() const; ///< -1: none.
    [[nodiscard]] int ownerOf(const QKeySequence& key, int except) const;

    Preferences m_preferences;
    std::vector<KeyBinding> m_bindings;
    QComboBox* m_theme = nullptr;
    QComboBox* m_language = nullptr;
    QComboBox* m_presenter = nullptr;
    QCheckBox* m_whitePaper = nullptr;
    QLineEdit* m_filter = nullptr;
    QTreeWidget* m_keys = nullptr;
    std::vector<QTreeWidgetItem*> m_items; ///< One for each binding.
    QKeySequenceEdit* m_newKey = nullptr;
    QPushButton* m_assign = nullptr;
    QPushButton* m_clear = nullptr;
    QPushButton* m_reset = nullptr;
    QPushButton* m_resetAll = nullptr;
    QLabel* m_remark = nullptr;
    bool m_filling = false;
};

} // namespace hairpaint::view
