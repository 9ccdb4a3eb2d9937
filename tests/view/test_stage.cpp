// Pictures frame hair and head, not the pedestal under them.
#include "model/files/head_file.h"
#include "tests/support/test_program.h"
#include "view/head_area/stage.h"

#include <QTest>

#include <algorithm>

using namespace hairpaint;
using rendering::Fit;
using rendering::StandardView;

namespace {

/// One hair that hangs down to `tipWo`, in a block of 16 lanes of which it is the first.
sim::StrandFrame hairTo(glm::vec3 tipWo)
{
    auto groom = std::make_shared<sim::Groom>();
    groom->visible = true;
    groom->nodes = 1;
    const auto chunk = std::make_shared<sim::StrandChunk>();
    chunk->leastDetail.fill(2.0F);
    chunk->leastDetail.front() = 0.0F;
    groom->chunks = {chunk};
    groom->packedChunk = {0};
    sim::StrandFrame frame;
    frame.groups.push_back({.groom = std::move(groom), .positions = std::vector<float>(std::size_t{3} * sim::kLanes)});
    for (std::size_t axis = 0; axis < 3; ++axis)
        frame.groups.front().positions[axis * sim::kLanes] = tipWo[static_cast<int>(axis)];
    return frame;
}

/// Where a point shows, -1..1 in the picture.
glm::vec2 shown(const rendering::Camera& camera, glm::vec3 positionWo)
{
    const glm::vec4 clip = camera.projection(1.0F) * camera.view() * glm::vec4(positionWo, 1.0F);
    return glm::vec2(clip) / clip.w;
}

} // namespace

class TestStage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void picturesFrameHairAndHeadAndNotThePedestal_data()
    {
        QTest::addColumn<StandardView>("view");
        QTest::newRow("front") << StandardView::Front;
        QTest::newRow("left") << StandardView::Left;
        QTest::newRow("three-quarter") << StandardView::ThreeQuarter;
    }
    void picturesFrameHairAndHeadAndNotThePedestal()
    {
        QFETCH(StandardView, view);
        const std::shared_ptr<const model::Head> head = model::defaultHead();
        const std::vector<glm::vec3>& mesh = head->skin->mesh().positionsHd;
        const glm::vec3 crown = *std::ranges::max_element(mesh, {}, &glm::vec3::y);
        const glm::vec3 foot = *std::ranges::min_element(mesh, {}, &glm::vec3::y);
        const sim::StrandFrame longHair = hairTo({0.0F, -0.5F, -0.1F});
        const sim::StrandFrame shortHair = hairTo(crown + glm::vec3(0.0F, 0.02F, 0.0F));

        const rendering::Camera ofShort = view::pictureCamera(view, Fit::Hair, *head, &shortHair, 1.0F);
        QVERIFY(shown(ofShort, crown).y > 0.6F && shown(ofShort, crown).y < 1.0F);
        QVERIFY(shown(ofShort, foot).y < -1.0F);
        const rendering::Camera ofLong = view::pictureCamera(view, Fit::Hair, *head, &longHair, 1.0F);
        const glm::vec2 tip = shown(ofLong, {0.0F, -0.5F, -0.1F});
        QVERIFY(tip.y < -0.85F && tip.y > -1.0F);
        QVERIFY(shown(ofLong, crown).y > 0.8F && shown(ofLong, crown).y < 1.0F);
        // The head alone, whatever hair there is; and all of the bust.
        QVERIFY(view::pictureCamera(view, Fit::Head, *head, &longHair, 1.0F) ==
                view::pictureCamera(view, Fit::Head, *head, nullptr, 1.0F));
        QVERIFY(shown(view::pictureCamera(view, Fit::Bust, *head, &longHair, 1.0F), foot).y > -1.0F);
    }

    void aHeadThatStandsHighFillsItsPicture()
    {
        // As of a figure whose origin is between its feet.
        const glm::vec3 up(0.0F, 1.6F, 0.0F);
        sim::HeadMesh mesh = model::defaultHead()->skin->mesh();
        for (glm::vec3& p : mesh.positionsHd)
            p += up;
        model::Head head = *model::defaultHead();
        head.builtIn = false;
        head.skin = std::make_shared<const sim::Skin>(std::move(mesh));
        const auto lowest = [&head](glm::vec3 tip) {
            const sim::StrandFrame hair = hairTo(tip);
            return shown(view::pictureCamera(StandardView::Front, Fit::Hair, head, &hair, 1.0F), tip).y;
        };
        const glm::vec3 tip = up + glm::vec3(0.0F, -0.5F, 0.0F);
        QVERIFY2(lowest(tip) < -0.85F && lowest(tip) > -1.0F, qPrintable(QString::number(lowest(tip))));
    }
};

HAIRPAINT_TEST(TestStage, Core)
#include "test_stage.moc"
