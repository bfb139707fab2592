#include "viewer/gl_textures.h"

#include <epoxy/gl.h>

namespace cairn::viewer {

namespace {

GLint code_of(TextureStyle::Wrap wrap) {
    switch (wrap) {
    case TextureStyle::Wrap::mirror:
        return GL_MIRRORED_REPEAT;
    case TextureStyle::Wrap::clamp:
        return GL_CLAMP_TO_EDGE;
    case TextureStyle::Wrap::repeat:
        break;
    }
    return GL_REPEAT;
}

// Color textures use an sRGB format, so that OpenGL filters them in linear light.
GlObject load(const TexturePicture& picture) {
    GlObject texture = make_texture();
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, picture.style.is_data ? GL_RGBA8 : GL_SRGB8_ALPHA8, picture.width, picture.height, 0,
                 GL_RGBA, GL_UNSIGNED_BYTE, picture.texels.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, picture.style.is_smooth ? GL_LINEAR : GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, code_of(picture.style.wrap_u));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, code_of(picture.style.wrap_v));
    return texture;
}

} // namespace

void GlTextures::use(const ShapeMesh& mesh, const GlProgram& program) {
    if (!mesh.texture && !mesh.finish) return;
    use(mesh.texture, 1, "u_texture", program);
    program.set("u_alpha_cutoff", mesh.texture ? mesh.texture->style.alpha_cutoff : 0.0f);
    if (mesh.finish) {
        const Finish& finish = *mesh.finish;
        use(finish.normals, 2, "u_normals", program);
        use(finish.rough, 3, "u_rough", program);
        use(finish.glows, 4, "u_glows", program);
        program.set("u_normal_scale", finish.normals ? finish.normal_scale : 0.0f);
        program.set("u_rough_metal", glm::vec2(finish.roughness, finish.metalness));
        program.set("u_glow", finish.glow * finish.glow_strength);
    }
    glActiveTexture(GL_TEXTURE0);
}

// A missing texture is replaced by a single white texel.
void GlTextures::use(const std::shared_ptr<const TexturePicture>& picture, int unit, const char* sampler,
                     const GlProgram& program) {
    static const auto white =
        std::make_shared<const TexturePicture>(TexturePicture{1, 1, {255, 255, 255, 255}, {}, nullptr});
    const std::shared_ptr<const TexturePicture>& shown = picture ? picture : white;
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    auto place = loaded_.find(shown.get());
    if (place == loaded_.end()) place = loaded_.emplace(shown.get(), Loaded{shown, load(*shown)}).first;
    place->second.unused = 0;
    glBindTexture(GL_TEXTURE_2D, place->second.texture.name());
    program.set(sampler, unit);
}

void GlTextures::give_up_unused(int most) {
    for (auto& [source, known] : loaded_) ++known.unused;
    std::erase_if(loaded_, [&](const auto& item) { return item.second.unused > most; });
}

} // namespace cairn::viewer
