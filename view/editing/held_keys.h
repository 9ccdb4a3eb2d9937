// Keys that change what dragging does while they are held: Space, H, O.
#pragma once

#include <QObject>
#include <QSet>

namespace hairpaint::view {

/// Watches the whole application, since the pointer decides which area is meant while the focus may be elsewhere.
/// Swallows nothing; while a text is being edited nothing counts as held.
class HeldKeys : public QObject
{
    Q_OBJECT
public:
    explicit HeldKeys(QSet<int> watched, QObject* parent = nullptr);
    [[nodiscard]] bool holds(Qt::Key key) const { return m_held.contains(key); }

Q_SIGNALS:
    void changed();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QSet<int> m_watched;
    QSet<int> m_held;
};

} // namespace hairpaint::view
