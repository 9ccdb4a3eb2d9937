// What waits until the program's first hair is seen.
#include "app/session/session.h"
#include "app/styles/library.h"
#include "app/window/first_hair.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "view/head_area/head_view.h"
#include "view/look/resources.h"

#include <QtTest>

#include <memory>

namespace hairpaint::app {

namespace {

model::Project fewHairs()
{
    model::Project project = starterProject();
    project.maxHairs = 2000;
    return project;
}

} // namespace

class TestFirstHair : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { view::initResources(); }

    void whatWaitsComesWithTheHairWhereNoAreaShowsIt()
    {
        Session session(fewHairs());
        FirstHair firstHair(session);
        int called = 0;
        bool isFrame = false;
        connect(&session, &Session::frameChanged, this, [&isFrame] { isFrame = true; });
        firstHair.then(&session, [&] {
            ++called;
            isFrame = isFrame && session.hair() == Session::Hair::Current;
        });
        QCOMPARE(called, 0);
        QTRY_COMPARE_WITH_TIMEOUT(called, 1, test::kPatienceMs);
        firstHair.then(&session, [&called] { ++called; });
        QCOMPARE(called, 2); // There is hair: nothing waits.
    }

    void itComesAfterThePictureWhereAnAreaShowsIt()
    {
        Session session(fewHairs());
        FirstHair firstHair(session);
        view::HeadView area(session.editor(), view::Theme::of(view::ThemeKind::Dark), view::PresenterChoice::Software);
        connect(&session, &Session::frameChanged, &area, &view::HeadView::setFrame);
        bool isMade = false;
        int drawnSince = 0;
        connect(&session, &Session::frameChanged, this, [&isMade] { isMade = true; });
        connect(&area, &view::HeadView::frameDrawn, this, [&] { drawnSince += isMade ? 1 : 0; });
        firstHair.showIn(area);
        int drawnBefore = -1;
        firstHair.then(&area, [&] { drawnBefore = drawnSince; });
        area.resize(200, 200);
        area.show();
        QTRY_VERIFY_WITH_TIMEOUT(drawnBefore >= 0, test::kPatienceMs);
        QCOMPARE(drawnBefore, 1);
    }

    void whoIsGoneHearsNothing()
    {
        Session session(fewHairs());
        FirstHair firstHair(session);
        bool isGoneCalled = false;
        bool isCalled = false;
        auto gone = std::make_unique<QObject>();
        firstHair.then(gone.get(), [&isGoneCalled] { isGoneCalled = true; });
        firstHair.then(&session, [&isCalled] { isCalled = true; });
        gone.reset();
        QTRY_VERIFY_WITH_TIMEOUT(isCalled, test::kPatienceMs);
        QVERIFY(!isGoneCalled);
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestFirstHair, Widgets)
#include "test_first_hair.moc"
