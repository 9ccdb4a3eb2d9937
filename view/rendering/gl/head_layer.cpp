// Draws head and solids with triangles and keeps the picture.
#include "view/rendering/gl/head_layer.h"

#include "sim/skin/mesh_openings.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace hairpaint::rendering {
namespace {

struct Vertex
{
    glm::vec3 positionHd;
    glm::vec3 normalHd;
    sim::SkinMarks marks;
    glm::vec2 uv;
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
    auto solidProgram = Program::graphics("head.vert", "head.frag", "#define SOLID\n");
    if (!solidProgram)
        return tl::unexpected(solidProgram.error());
    layer->m_solidProgram = std::move(*solidProgram);
    layer->m_framebuffer = makeFramebuffer();
    return layer;
}

void HeadLayer::Mesh::upload(const std::shared_ptr<const sim::HeadMesh>& head, bool open)
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
                     .marks = head->marks.empty() ? sim::SkinMarks{} : head->marks[i],
                     .uv = i < head->uvs.size() ? head->uvs[i] : glm::vec2(0.0F)};
    vertices.assign(packed.data(), packed.size() * sizeof(Vertex));
    indices.assign(head->triangles.data(), head->triangles.size() * sizeof(glm::uvec3));
    indexCount = static_cast<int>(head->triangles.size() * 3);
    closed = !open && sim::openEdges(*head).empty();
    vertexArray = makeVertexArray();
    glBindVertexArray(vertexArray.id());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.id());
    glBindVertexBuffer(0, vertices.id(), 0, sizeof(Vertex));
    glVertexAttribFormat(0, 3, GL_FLOAT, GL_FALSE, offsetof(Vertex, positionHd));
    glVertexAttribFormat(1, 3, GL_FLOAT, GL_FALSE, offsetof(Vertex, normalHd));
    glVertexAttribFormat(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(Vertex, marks));
    glVertexAttribFormat(4, 2, GL_FLOAT, GL_FALSE, offsetof(Vertex, uv));
    for (const unsigned attribute : {0U, 1U, 2U, 4U}) {
        glEnableVertexAttribArray(attribute);
        glVertexAttribBinding(attribute, 0);
    }
    glBindVertexArray(0);
}

void HeadLayer::Mesh::uploadTexture(const std::shared_ptr<const sim::MeshTexture>& picture)
{
    if (shown == picture)
        return;
    shown = picture;
    if (!picture)
        return;
    // Row 0 is v = 1: turned over, so that uvs serve as they are.
    const std::size_t row = std::size_t{4} * picture->width;
    std::vector<std::uint8_t> upright(picture->rgba.size());
    for (std::size_t y = 0; y < picture->height; ++y)
        std::copy_n(picture->rgba.begin() + static_cast<std::ptrdiff_t>(y * row), row,
                    upright.begin() + static_cast<std::ptrdiff_t>((picture->height - 1 - y) * row));
    texture.resize2D(GL_SRGB8_ALPHA8, static_cast<int>(picture->width), static_cast<int>(picture->height), true);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, static_cast<int>(picture->width), static_cast<int>(picture->height),
                    GL_RGBA, GL_UNSIGNED_BYTE, upright.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    glBindTexture(GL_TEXTURE_2D, 0);
}

void HeadLayer::Mesh::bindTexture(const Program& program, float leastAlpha) const
{
    constexpr int kTextureUnit = 0;
    program.set("skinTextured", glm::vec4(shown ? 1.0F : 0.0F, leastAlpha, 0.0F, 0.0F));
    program.set("skinTexture", kTextureUnit);
    if (shown)
        texture.bind(static_cast<unsigned>(kTextureUnit));
}

void HeadLayer::Mesh::uploadTint(const ScalpTintSources& tintSources)
{
    constexpr unsigned kAttribute = 3;
    constexpr unsigned kBinding = 1;
    if (!tint.update(source, tintSources) || indexCount == 0)
        return;
    const std::span<const ScalpTint::Texel> texels = tint.texels();
    glBindVertexArray(vertexArray.id());
    if (texels.empty()) {
        glDisableVertexAttribArray(kAttribute);
    } else {
        tints.assign(texels.data(), texels.size_bytes());
        glBindVertexBuffer(kBinding, tints.id(), 0, sizeof(ScalpTint::Texel));
        glVertexAttribFormat(kAttribute, 4, GL_UNSIGNED_SHORT, GL_TRUE, 0);
        glEnableVertexAttribArray(kAttribute);
        glVertexAttribBinding(kAttribute, kBinding);
    }
    glBindVertexArray(0);
}

bool HeadLayer::draw(const Scene& scene, bool coarse, const FrameConstants& constants)
{
    const FrameConstants part = withoutHair(constants);
    const bool sameView = scene.head == m_head && scene.cards == m_cards && scene.solids == m_solids &&
                          scene.skinTexture == m_fine.shown && part == m_drawnWith;
    ScalpTintSources tintSources = scalpTintSources(scene.hair.get());
    if (sameView && !m_isCoarse && tintSources == m_tintSources)
        return false;
    m_tintSources = std::move(tintSources);
    m_head = scene.head;
    m_cards = scene.cards;
    m_solids = scene.solids;
    m_drawnWith = part;
    m_isCoarse = !sameView && coarse && scene.headInMotion;
    Mesh& mesh = m_isCoarse ? m_coarse : m_fine;
    mesh.upload(m_isCoarse ? scene.headInMotion : scene.head);
    mesh.uploadTint(m_tintSources);
    m_fine.uploadTexture(scene.skinTexture); // On the coarse head too.

    const auto width = static_cast<int>(constants.target.x);
    const auto height = static_cast<int>(constants.target.y);
    m_colour.resize2D(GL_RGBA8, width, height);
    m_depth.resize2D(GL_DEPTH_COMPONENT32F, width, height);
    m_worn.resize2D(GL_R8, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_colour.id(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, m_worn.id(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, m_depth.id(), 0);
    constexpr std::array<unsigned, 2> kColourAndWorn{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(2, kColourAndWorn.data());
    glViewport(0, 0, width, height);
    const float nothing[] = {0.0F, 0.0F, 0.0F, 0.0F};
    const float far = 1.0F;
    glClearBufferfv(GL_COLOR, 0, nothing);
    glClearBufferfv(GL_COLOR, 1, nothing);
    glClearBufferfv(GL_DEPTH, 0, &far);
    glDrawBuffers(1, kColourAndWorn.data());
    if (mesh.indexCount > 0) {
        m_program.use();
        glVertexAttrib4f(3, 0.0F, 0.0F, 0.0F, 0.0F); // Where nothing tints.
        m_fine.bindTexture(m_program, 0.0F);
        mesh.draw();
    }
    glDrawBuffers(2, kColourAndWorn.data());
    drawSolids();
    glDrawBuffers(1, kColourAndWorn.data());
    if (m_cards)
        m_cardLayer.draw(m_cards);
    return true;
}

void HeadLayer::drawSolids()
{
    std::erase_if(m_solidMeshes, [this](const Mesh& mesh) {
        return std::ranges::find(m_solids, mesh.source, &Solid::mesh) == m_solids.end();
    });
    for (const Solid& solid : m_solids) {
        auto mesh = std::ranges::find(m_solidMeshes, solid.mesh, &Mesh::source);
        if (mesh == m_solidMeshes.end()) {
            mesh = m_solidMeshes.emplace(m_solidMeshes.end());
            mesh->upload(solid.mesh, solid.open);
            mesh->uploadTexture(solid.texture);
        }
        const SkinShading skin = skinOf(solid);
        const glm::quat& rotation = solid.shape.rotation;
        m_solidProgram.use();
        m_solidProgram.set("solidCentreHd", glm::vec4(solid.shape.centreHd, 0.0F));
        m_solidProgram.set("solidSemiAxesM", glm::vec4(solid.shape.semiAxesM, 0.0F));
        m_solidProgram.set("solidRotation", glm::vec4(rotation.x, rotation.y, rotation.z, rotation.w));
        mesh->bindTexture(m_solidProgram, solid.masked ? 0.5F : 0.0F);
        m_solidProgram.set("solidSkin[0]", glm::vec4(skin.colour, skin.scatter));
        m_solidProgram.set("solidSkin[1]", glm::vec4(skin.lips, skin.grain));
        m_solidProgram.set("solidSkin[2]", glm::vec4(skin.lids, skin.sheen));
        mesh->draw();
    }
}

void HeadLayer::Mesh::draw() const
{
    glEnable(GL_DEPTH_TEST);
    if (closed)
        glEnable(GL_CULL_FACE);
    glBindVertexArray(vertexArray.id());
    glDrawElements(GL_TRIANGLES, indexCount, GL_UNSIGNED_INT, nullptr);
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
