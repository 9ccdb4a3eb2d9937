// Cut, copy, paste, fill and clear of the selected texels, as the menus and keys ask for them.
#pragma once

#include "app/session/session.h"
#include "model/tools/clipboard.h"

#include <QObject>

#include <optional>

namespace hairpaint::app {

/// Holds what was copied last, which other programs get as an image; an image that one of them copied since replaces
/// it. Works on the active layer of the session, which outlives it; each change is one undo
/// step. GUI thread.
class ClipCommands : public QObject
{
    Q_OBJECT
public:
    explicit ClipCommands(Session& session);

    void cut();
    void copy();
    void paste();
    void fill(); ///< With the value that the tools lay.
    void clear();

Q_SIGNALS:
    void told(const QString& message); ///< For the status bar.

private:
    void offerImage(); ///< Of what was copied, to other programs.
    /// What another program has copied since; none where the newest copy is ours, or no image.
    [[nodiscard]] std::optional<model::Clip> foreignClip() const;
    /// Whether the active layer may be changed; the reason is shown where it may not.
    [[nodiscard]] bool mayChange();
    void clearSelected(const QString& text); ///< %1 in the step's text becomes the map's name.

    Session& m_session;
    std::optional<model::Clip> m_clip;
    QByteArray m_mark; ///< Tells our own copy in the system's clipboard from others.
};

} // namespace hairpaint::app
