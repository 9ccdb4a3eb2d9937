// Styles read from their files and carried to the head that is open; the last few stay in memory.
#pragma once

#include "model/document/document.h"
#include "model/styles/preset.h"
#include "model/values/error.h"

#include <QObject>

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace hairpaint::view {

using PresetPtr = std::shared_ptr<const model::Preset>;

/// GUI thread; files are read wherever `start` runs the loader.
class StyleShelf : public QObject
{
    Q_OBJECT
public:
    using Loader = std::function<model::Result<model::Preset>(const QString& path)>;

    /// Has `load` run, which takes a while, and tells `done` on this thread, unless `receiver` is gone by then. What
    /// `load` throws becomes an error that names `doing`.
    using Start = std::function<void(const QString& doing, const std::function<model::Result<model::Preset>()>& load,
                                     QObject* receiver, const std::function<void(model::Result<model::Preset>)>& done)>;

    StyleShelf(model::Document& document, Loader loader, Start start, QObject* parent);

    /// One of the signals follows, at once where the style is in memory.
    void want(const QString& path);
    void forget(); ///< The files may hold others now.

Q_SIGNALS:
    void came(const QString& path, const hairpaint::view::PresetPtr& preset);
    void failed(const QString& path, const QString& problem);
    void busyChanged(const QString& path, bool busy);

private:
    void read(const QString& path, model::Result<model::Preset> result);

    model::Document& m_document;
    Loader m_loader;
    Start m_start;
    std::vector<std::pair<QString, PresetPtr>> m_recent;
    std::vector<QString> m_loading;
};

} // namespace hairpaint::view
