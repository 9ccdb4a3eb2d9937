// What comes in from other programs and goes out to them, in the window.
#pragma once

#include "app/exchange/hair_exchange.h"
#include "app/exchange/head_exchange.h"
#include "app/exchange/map_exchange.h"
#include "app/exchange/picture_exchange.h"
#include "app/exchange/style_files.h"
#include "app/exchange/worn_exchange.h"

namespace hairpaint::app {

/// Everything of its kind that the menus offer, with the one FileWork through which it asks and tells. GUI thread.
class Exchange
{
public:
    Exchange(Session& session, Settings& settings, Jobs& jobs, QWidget& window)
        : m_work(settings, jobs, window), m_hair(session, m_work), m_heads(session, m_work), m_maps(session, m_work),
          m_pictures(session, m_work, m_hair), m_styles(session, m_work), m_worn(session, m_work)
    {}

    [[nodiscard]] FileWork& work() { return m_work; }
    [[nodiscard]] HairExchange& hair() { return m_hair; }
    [[nodiscard]] HeadExchange& heads() { return m_heads; }
    [[nodiscard]] MapExchange& maps() { return m_maps; }
    [[nodiscard]] PictureExchange& pictures() { return m_pictures; }
    [[nodiscard]] StyleFiles& styles() { return m_styles; }
    [[nodiscard]] WornExchange& worn() { return m_worn; }

private:
    FileWork m_work;
    HairExchange m_hair;
    HeadExchange m_heads;
    MapExchange m_maps;
    PictureExchange m_pictures;
    StyleFiles m_styles;
    WornExchange m_worn;
};

} // namespace hairpaint::app
