// Reading in the background, one file once.
#include "view/panels/style_shelf.h"

#include "model/styles/style_transfer.h"

#include <QFileInfo>

#include <algorithm>

namespace hairpaint::view {

namespace {

constexpr std::size_t kKept = 10; ///< Styles that stay in memory.

/// Here and not when it is shown: it takes a while.
model::Result<model::Preset> onHead(model::Result<model::Preset> read, const std::shared_ptr<const model::Head>& head)
{
    if (!read)
        return read;
    return *model::carriedPreset(std::move(*read), head);
}

} // namespace

StyleShelf::StyleShelf(model::Document& document, Loader loader, Start start, QObject* parent)
    : QObject(parent), m_document(document), m_loader(std::move(loader)), m_start(std::move(start))
{}

void StyleShelf::forget()
{
    m_recent.clear();
}

void StyleShelf::want(const QString& path)
{
    const auto known = std::ranges::find(m_recent, path, &std::pair<QString, PresetPtr>::first);
    const std::shared_ptr<const model::Head> head = m_document.committed().head;
    if (known != m_recent.end() && !model::canCarry(known->second->head, head)) {
        Q_EMIT came(path, PresetPtr(known->second));
        return;
    }
    Q_EMIT busyChanged(path, true);
    if (std::ranges::find(m_loading, path) != m_loading.end())
        return;
    m_loading.push_back(path);
    m_start(
        tr("Reading %1").arg(QFileInfo(path).fileName()),
        [path, head, load = m_loader] { return onHead(load(path), head); }, this,
        [this, path](model::Result<model::Preset> result) { read(path, std::move(result)); });
}

void StyleShelf::read(const QString& path, model::Result<model::Preset> result)
{
    std::erase(m_loading, path);
    Q_EMIT busyChanged(path, false);
    if (!result) {
        Q_EMIT failed(path, result.error().message);
        return;
    }
    if (model::canCarry(result->head, m_document.committed().head)) {
        want(path); // Another head has come meanwhile.
        return;
    }
    const auto preset = std::make_shared<const model::Preset>(std::move(*result));
    std::erase_if(m_recent, [&path](const auto& one) { return one.first == path; }); // On another head.
    m_recent.emplace_back(path, preset);
    if (m_recent.size() > kKept)
        m_recent.erase(m_recent.begin());
    Q_EMIT came(path, preset);
}

} // namespace hairpaint::view
