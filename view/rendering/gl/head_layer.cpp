// Draws the head with triangles and keeps the picture.
#include "view/rendering/gl/head_layer.h"

#include "sim/skin/mesh_openings.h"

#include <epoxy/gl.h>

#include <cstddef>
#include <vector>

namespace hairpaint::rendering {
namespace {

struct Vertex
{
    glm::vec3 positionHd;
    glm::vec3 normalHd;
    sim::SkinMarks marks;
};

} // namespace

tl::expected<std::unique_ptr<HeadLayer>, std::string> HeadLayer::create()
{
    auto cards = CardLayer::create();
    if (!cards)
        return tl::unexpected(cards.error());
    std::unique_ptr<HeadLayer> layer(new HeadLayer(std::move(*cards)));
    auto program = Program::graphics("head.vert", "head.frag");
    if (!program)
        return tl::unexpected(program.error());
    layer->m_program = std::move(*program);
    layer->m_framebuffer = makeFramebuffer();
    return layer;
}

void HeadLayer::Mesh::upload(const std::shared_ptr<const sim::HeadMesh>& head)
{
    if (source == head)
        return;
    source = head;
    indexCount = 0;
    if (!head)
        return;
    std::vector<Vertex> packed(head->positionsHd.size());
    for (std::size_t i = 0; i < packed.size(); ++i)
        packed[i] = {.positionHd = head->positionsHd[i],
                     .normalHd = head->normalsHd[i],
                     .marks = head->marks.empty() ? sim::SkinMarks{} : head->marks[i]};
    vertices.assign(packed.data(), packed.size() * sizeof(Vertex));
    indices.assign(head->triangles.data(), head->triangles.size() * sizeof(glm::uvec3));
    indexCount = static_cast<int>(head->triangles.size() * 3);
    closed = sim::openEdges(*head).empty();
    vertexArray = makeVertexArray();
    glBindVertexArray(vertexArray.id());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.id());
    glBindVertexBuffer(0, vertices.id(), 0, sizeof(Vertex));
    glVertexAttribFormat(0, 3, GL_FLOAT, GL_FALSE, offsetof(Vertex, positionHd));
    glVertexAttribFormat(1, 3, GL_FLOAT, GL_FALSE, offsetof(Vertex, normalHd));
    glVertexAttribFormat(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(Vertex, marks));
    for (unsigned attribute = 0; attribute < 3; ++attribute) {
        glEnableVertexAttribArray(attribute);
        glVertexAttribBinding(attribute, 0);
    }
    glBindVertexArray(0);
}

bool HeadLayer::draw(const std::shared_ptr<const sim::HeadMesh>& head,
                     const std::shared_ptr<const sim::HeadMesh>& inMotion, const std::shared_ptr<const CardSet>& cards,
                     const FrameConstants& constants)
{
    const FrameConstants part = withoutHair(constants);
    const bool same = head == m_head && cards == m_cards && part == m_drawnWith;
    if (same && !m_isCoarse)
        return false;
    m_head = head;
    m_cards = cards;
    m_drawnWith = part;
    m_isCoarse = !same && inMotion;
    Mesh& mesh = m_isCoarse ? m_coarse : m_fine;
    mesh.upload(m_isCoarse ? inMotion : head);

    const auto width = static_cast<int>(constants.target.x);
    const auto height = static_cast<int>(constants.target.y);
    m_colour.resize2D(GL_RGBA8, width, height);
    m_depth.resize2D(GL_DEPTH_COMPONENT32F, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_colour.id(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, m_depth.id(), 0);
    glViewport(0, 0, width, height);
    const float nothing[] = {0.0F, 0.0F, 0.0F, 0.0F};
    const float far = 1.0F;
    glClearBufferfv(GL_COLOR, 0, nothing);
    glClearBufferfv(GL_DEPTH, 0, &far);
    if (mesh.indexCount > 0)
        drawMesh(mesh);
    if (cards)
        m_cardLayer.draw(cards);
    return true;
}

void HeadLayer::drawMesh(const Mesh& mesh) const
{
    glEnable(GL_DEPTH_TEST);
    if (mesh.closed)
        glEnable(GL_CULL_FACE);
    m_program.use();
    glBindVertexArray(mesh.vertexArray.id());
    glDrawElements(GL_TRIANGLES, mesh.indexCount, GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
}

void HeadLayer::bind(unsigned colourUnit, unsigned depthUnit) const
{
    m_colour.bind(colourUnit);
    m_depth.bind(depthUnit);
}

} // namespace hairpaint::rendering
