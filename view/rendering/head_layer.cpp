// Draws the head with triangles and keeps the picture.
#include "view/rendering/head_layer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <vector>

namespace hairpaint::rendering {
namespace {

struct Vertex
{
    glm::vec3 positionHd;
    glm::vec3 normalHd;
};

/// The part of the constants that the head's picture depends on.
FrameConstants partOfHead(FrameConstants constants)
{
    constants.gridFromWo = {};
    constants.depthRange = glm::vec4(0.0F);
    constants.gridSize = glm::vec4(0.0F);
    constants.background = {};
    constants.ringWo = {};
    return constants;
}

/// Whether every edge has a triangle on either side, vertices at the same place taken as one.
bool isClosed(const sim::HeadMesh& head)
{
    std::vector<unsigned> order(head.positionsHd.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto place = [&](unsigned i) {
        const glm::vec3& p = head.positionsHd[i];
        return std::tuple(p.x, p.y, p.z);
    };
    std::sort(order.begin(), order.end(), [&](unsigned a, unsigned b) { return place(a) < place(b); });
    std::vector<unsigned> welded(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        welded[order[i]] = i > 0 && place(order[i]) == place(order[i - 1]) ? welded[order[i - 1]] : order[i];
    std::vector<std::uint64_t> edges; // Directed; the one of the neighbour runs the other way.
    edges.reserve(head.triangles.size() * 3);
    for (const glm::uvec3& triangle : head.triangles)
        for (int k = 0; k < 3; ++k) {
            const std::uint64_t from = welded[triangle[k]];
            const std::uint64_t to = welded[triangle[(k + 1) % 3]];
            if (from != to)
                edges.push_back((from << 32U) | to);
        }
    std::sort(edges.begin(), edges.end());
    return std::all_of(edges.begin(), edges.end(), [&](std::uint64_t edge) {
        return std::binary_search(edges.begin(), edges.end(), (edge << 32U) | (edge >> 32U));
    });
}

} // namespace

tl::expected<std::unique_ptr<HeadLayer>, std::string> HeadLayer::create()
{
    std::unique_ptr<HeadLayer> layer(new HeadLayer);
    auto program = Program::graphics("head.vert", "head.frag");
    if (!program)
        return tl::unexpected(program.error());
    layer->m_program = std::move(*program);
    layer->m_vertexArray = makeVertexArray();
    layer->m_framebuffer = makeFramebuffer();
    return layer;
}

void HeadLayer::upload(const sim::HeadMesh& head)
{
    std::vector<Vertex> vertices(head.positionsHd.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
        vertices[i] = {.positionHd = head.positionsHd[i], .normalHd = head.normalsHd[i]};
    m_vertices.assign(vertices.data(), vertices.size() * sizeof(Vertex));
    m_indices.assign(head.triangles.data(), head.triangles.size() * sizeof(glm::uvec3));
    m_indexCount = static_cast<int>(head.triangles.size() * 3);
    m_closed = isClosed(head);
    glBindVertexArray(m_vertexArray.id());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_indices.id());
    glBindVertexBuffer(0, m_vertices.id(), 0, sizeof(Vertex));
    for (unsigned attribute = 0; attribute < 2; ++attribute) {
        glEnableVertexAttribArray(attribute);
        glVertexAttribFormat(attribute, 3, GL_FLOAT, GL_FALSE, attribute * static_cast<unsigned>(sizeof(glm::vec3)));
        glVertexAttribBinding(attribute, 0);
    }
    glBindVertexArray(0);
}

bool HeadLayer::draw(const std::shared_ptr<const sim::HeadMesh>& head, const FrameConstants& constants)
{
    const FrameConstants part = partOfHead(constants);
    if (head == m_head && part == m_drawnWith)
        return false;
    if (head != m_head && head)
        upload(*head);
    m_head = head;
    m_drawnWith = part;

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
    if (!head || m_indexCount == 0)
        return true;
    glEnable(GL_DEPTH_TEST);
    if (m_closed)
        glEnable(GL_CULL_FACE);
    m_program.use();
    glBindVertexArray(m_vertexArray.id());
    glDrawElements(GL_TRIANGLES, m_indexCount, GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    return true;
}

void HeadLayer::bind(unsigned colourUnit, unsigned depthUnit) const
{
    m_colour.bind(colourUnit);
    m_depth.bind(depthUnit);
}

} // namespace hairpaint::rendering
