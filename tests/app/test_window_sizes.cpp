// The real window in its sizes, themes and languages: nothing is cut off and the hair shows. What it looks like is left
// as pictures in the folder window_sizes beside the program.
#include "app/settings/languages.h"
#include "app/styles/library.h"
#include "app/window/main_window.h"
#include "tests/app/thin_project.h"
#include "tests/support/clipping.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "view/head_area/head_view.h"
#include "view/look/resources.h"

#include <QDir>
#include <QStandardPaths>
#include <QTranslator>
#include <QtTest>

#include <memory>

namespace hairpaint::app {

class TestWindowSizes : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        view::initResources();
    }
    void cleanup()
    {
        qDeleteAll(qApp->findChildren<QTranslator*>(Qt::FindDirectChildrenOnly));
        QLocale::setDefault(QLocale::system());
        SettingsStore().clear();
    }

    void nothingIsCutOffAndHairShows_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<QString>("language");
        QTest::addColumn<bool>("light");
        // At 200 % the same screens have half as many points.
        const auto sizes = qApp->devicePixelRatio() > 1.0 ? QList<QSize>{{960, 600}, {1920, 1080}}
                                                          : QList<QSize>{{960, 600}, {1440, 900}, {3840, 2160}};
        for (const QSize size : sizes) {
            const auto row = [size](const char* language, bool light) {
                QTest::addRow("%d x %d, %s, %s", size.width(), size.height(), language, light ? "light" : "dark")
                    << size << QString::fromLatin1(language) << light;
            };
            row("en", false);
            row("es", true);
        }
    }
    void nothingIsCutOffAndHairShows()
    {
        QFETCH(QSize, size);
        QFETCH(QString, language);
        QFETCH(bool, light);
        QCOMPARE(speak(language), language);
        view::Preferences preferences;
        preferences.theme = light ? view::ThemeKind::Light : view::ThemeKind::Dark;
        Settings().setPreferences(preferences);
        MainWindow window(test::thinned(starterProject()));
        window.resize(size);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QCOMPARE(window.size(), size);
        const auto hairShows = [&window] {
            return window.session().hair() == Session::Hair::Current && !window.headView().awake();
        };
        QTRY_VERIFY_WITH_TIMEOUT(hairShows() && test::clipped(window).isEmpty(), test::kPatienceMs);
        const QImage picture = window.grab().toImage();
        QCOMPARE(picture.size(), size * qApp->devicePixelRatio());

        QString name = QString::fromLatin1(QTest::currentDataTag());
        name += QStringLiteral(" at %1.png").arg(qApp->devicePixelRatio());
        const QDir folder(QCoreApplication::applicationDirPath() + QStringLiteral("/window_sizes"));
        QVERIFY(folder.mkpath(QStringLiteral(".")));
        QVERIFY(picture.save(folder.filePath(name.replace(QLatin1Char(' '), QLatin1Char('_')))));
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestWindowSizes, Widgets)
#include "test_window_sizes.moc"
