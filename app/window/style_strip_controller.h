// Fills the strip of styles from the library and does what its tiles ask for.
#pragma once

#include "app/background/jobs.h"
#include "app/exchange/style_files.h"
#include "app/styles/style_cards.h"
#include "app/styles/style_pictures.h"
#include "view/panels/style_strip.h"

#include <QObject>

namespace hairpaint::app {

/// The library is read in the background, anew whenever `styles` changes it. Belongs to the strip; `styles`,
/// settings and the jobs outlive both. GUI thread.
class StyleStripController : public QObject
{
    Q_OBJECT
public:
    StyleStripController(view::StyleStrip& strip, StyleFiles& styles, Settings& settings, Jobs& jobs,
                         model::Document& document);
    void refresh();

Q_SIGNALS:
    void failed(const QString& problem);
    void landmarksWanted(); ///< The landmarks of the open head are to be set.

private:
    view::StyleStrip& m_strip;
    Settings& m_settings;
    Jobs& m_jobs;
    StylePictures m_pictures;
    StyleCards m_cards;
    int m_newest = 0; ///< Number of the list that was asked for last.
};

} // namespace hairpaint::app
