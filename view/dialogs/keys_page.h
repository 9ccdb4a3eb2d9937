// The preferences' page of keys.
#pragma once

#include <QAction>
#include <QKeySequence>
#include <QList>
#include <QWidget>

#include <vector>

class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace hairpaint::view {

/// An action whose key can be changed.
struct KeyBinding
{
    QAction* action = nullptr;       ///< Not owned; its shortcut is shown.
    QString section;                 ///< "File"
    QString name;                    ///< "Undo": the menu's words without marks, and without what changes in them.
    QList<QKeySequence> defaultKeys; ///< The first one is listed; none: it has no key of its own.
    [[nodiscard]] QKeySequence defaultKey() const { return defaultKeys.value(0); }
};

/// A key that is given to an action is taken from the one that had it. What changes takes effect at once.
class KeysPage : public QWidget
{
    Q_OBJECT
public:
    explicit KeysPage(std::vector<KeyBinding> bindings, QWidget* parent = nullptr);

Q_SIGNALS:
    /// The page set it on the action already; the application remembers it.
    void keyChanged(QAction* action, const QKeySequence& key);
    /// It has its own keys again; the application forgets what it remembered.
    void keyReset(QAction* action);

private:
    void build();
    void fill();
    void filter(const QString& text);
    void follow();
    void setKey(int binding, const QKeySequence& key);
    void resetKey(int binding);
    void resetAll();
    void put(int binding, const QList<QKeySequence>& keys);
    [[nodiscard]] int current() const; ///< The chosen binding; -1: none.
    [[nodiscard]] int ownerOf(const QKeySequence& key, int except) const;

    std::vector<KeyBinding> m_bindings;
    QLineEdit* m_filter = nullptr;
    QTreeWidget* m_keys = nullptr;
    std::vector<QTreeWidgetItem*> m_items; ///< One for each binding.
    QKeySequenceEdit* m_newKey = nullptr;
    QPushButton* m_assign = nullptr;
    QPushButton* m_clear = nullptr;
    QPushButton* m_reset = nullptr;
    QPushButton* m_resetAll = nullptr;
    QLabel* m_remark = nullptr;
};

} // namespace hairpaint::view
