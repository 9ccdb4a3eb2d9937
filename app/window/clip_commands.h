// Cut, copy, paste, fill and clear of the selected texels, as the menus and keys ask for them.
#pragma once

#include "app/exchange/map_exchange.h"
#include "app/session/session.h"
#include "app/window/dropped_file.h"
#include "model/tools/selecting/clipboard.h"

#include <QObject>

#include <optional>

namespace hairpaint::app {

/// Holds what was copied last, which other windows get whole (clip_data.h) and other programs as an image; what one of
/// them copied since replaces it, also where it can not be pasted. Works on the active layer of the session, which
/// outlives it; each change is one undo step. GUI thread.
class ClipCommands : public QObject
{
    Q_OBJECT
public:
    ClipCommands(Session& session, MapExchange& maps);

    void cut();
    void copy();
    void paste();
    void take(const Dropped& dropped); ///< Pastes what was dropped on the window.
    void fill();                       ///< Fills with the value that the tools paint.
    void clear();

Q_SIGNALS:
    void told(const QString& message);          ///< A message for the status bar.
    void filesWanted(const QStringList& paths); ///< Files in the clipboard, or dropped, to be loaded.

private:
    void offerImage(); ///< Offers what was copied to other programs as an image.
    /// Makes m_clip what the system's clipboard holds now; false where that has been dealt with, or can't be pasted.
    [[nodiscard]] bool takeClipboard();
    /// Whether the active layer may be changed; the reason is shown where it may not.
    [[nodiscard]] bool mayChange();
    void lay(const model::Clip& clip);
    void clearSelected(const QString& text); ///< %1 in the step's text becomes the map's name.

    Session& m_session;
    MapExchange& m_maps;
    std::optional<model::Clip> m_clip;
    QByteArray m_mark; ///< Tells our own copy in the system's clipboard from others.
};

} // namespace hairpaint::app
