#include "sim/shape/files/assimp_reader.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <sstream>
#include <utility>
#include <vector>

#include <assimp/BaseImporter.h>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/scene.h>

#include "sim/base/input_error.h"
#include "sim/shape/polygon.h"

// assimp parses the validated bytes into a graph of nodes, each with a transform and meshes. It
// runs without any of its post-processing steps: triangulation, welding and orientation are done by
// our own code, in the same way for all formats. Nothing but geometry is read.
namespace prehend {
namespace {

// A read-only stream over bytes in memory. assimp gets the validated bytes of a file, not the file
// itself.
class BytesStream final : public Assimp::IOStream {
 public:
  explicit BytesStream(const std::string& bytes) : bytes_(bytes) {}

  size_t Read(void* to, size_t size, size_t count) override {
    if (size == 0) return 0;
    const size_t items = std::min(count, (bytes_.size() - at_) / size);
    std::memcpy(to, bytes_.data() + at_, items * size);
    at_ += items * size;
    return items;
  }
  size_t Write(const void*, size_t, size_t) override { return 0; }
  aiReturn Seek(size_t offset, aiOrigin origin) override {
    const size_t from = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? at_ : bytes_.size();
    if (offset > bytes_.size() - from) return aiReturn_FAILURE;
    at_ = from + offset;
    return aiReturn_SUCCESS;
  }
  size_t Tell() const override { return at_; }
  size_t FileSize() const override { return bytes_.size(); }
  void Flush() override {}

 private:
  const std::string& bytes_;
  size_t at_ = 0;
};

// The file system that assimp sees: one file. Buffers, materials, textures and everything else do
// not exist, so a mesh file cannot make assimp open other files.
class ClosedFileSystem final : public Assimp::IOSystem {
 public:
  ClosedFileSystem(std::string file, const std::string& bytes)
      : file_(std::move(file)), bytes_(bytes) {}

  bool Exists(const char* name) const override { return name == file_; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* name, const char*) override {
    return name == file_ ? new BytesStream(bytes_) : nullptr;
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
  std::string file_;
  const std::string& bytes_;
};

// Removes all importers that do not read this extension. assimp otherwise guesses the format from
// the content when the extension fails.
void keep_importers(Assimp::Importer& importer, const std::string& extension) {
  std::vector<Assimp::BaseImporter*> others;
  for (size_t i = 0; i < importer.GetImporterCount(); ++i) {
    std::istringstream known(importer.GetImporterInfo(i)->mFileExtensions);
    bool reads = false;
    for (std::string name; known >> name;) reads = reads || name == extension;
    if (!reads) others.push_back(importer.GetImporter(i));
  }
  for (Assimp::BaseImporter* other : others) {
    importer.UnregisterLoader(other);
    delete other;  // unregistering passes ownership to the caller
  }
}

// A message of assimp without line breaks and control characters, cut to a length that fits a line.
std::string one_line(const std::string& text) {
  constexpr size_t kLongest = 200;
  std::string line;
  for (const char c : text) {
    const bool printable = std::isprint(static_cast<unsigned char>(c)) != 0;
    if (printable || (!line.empty() && line.back() != ' ')) line += printable ? c : ' ';
    if (line.size() == kLongest) break;
  }
  return line;
}

Vector3 vertex_of(const aiMesh& part, unsigned i) {
  const aiVector3D& v = part.mVertices[i];
  return {v.x, v.y, v.z};
}

// Triangulates a face of a part whose vertices start at index `first` of the mesh. Triangulation
// takes O(n^2) time, hence the limit of corners.
void add_face(TriangleMesh& mesh, const aiMesh& part, const aiFace& face, int first) {
  constexpr unsigned kMostCorners = 10'000;
  const unsigned n = face.mNumIndices;
  if (n < 3) return;
  if (n > kMostCorners) {
    throw InputError("a face with " + std::to_string(n) + " corners, more than " +
                     std::to_string(kMostCorners));
  }
  for (unsigned k = 0; k < n; ++k) {
    if (face.mIndices[k] >= part.mNumVertices) {
      throw InputError("a face refers to vertex " + std::to_string(face.mIndices[k]) + " of " +
                       std::to_string(part.mNumVertices));
    }
  }
  std::vector<Vector3> corners;
  for (unsigned k = 0; k < n; ++k) corners.push_back(vertex_of(part, face.mIndices[k]));
  const auto index = [&](int k) { return first + static_cast<int>(face.mIndices[k]); };
  for (const Triangle& t : triangulate_face(corners)) {
    mesh.triangles.push_back({index(t[0]), index(t[1]), index(t[2])});
  }
}

Eigen::Affine3d transform_of(const aiMatrix4x4& m) {
  Eigen::Affine3d X;
  X.matrix() << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, 0, 0, 0, 1;
  return X;
}

// Appends the meshes of all nodes, depth first. A mesh may be referenced by several nodes: the
// limit of vertices keeps a small file from expanding to more than the memory holds.
void add_nodes(TriangleMesh& mesh, const aiScene& scene) {
  constexpr std::size_t kMostVertices = 50'000'000;
  std::vector<std::pair<const aiNode*, Eigen::Affine3d>> open{
      {scene.mRootNode, Eigen::Affine3d::Identity()}};
  while (!open.empty()) {
    const auto [node, X_FileParent] = open.back();
    open.pop_back();
    const Eigen::Affine3d X_FileNode = X_FileParent * transform_of(node->mTransformation);
    // A transform with a negative determinant mirrors the surface, which reverses the winding: the
    // triangles are turned back.
    const bool mirrored = X_FileNode.linear().determinant() < 0.0;
    for (unsigned i = 0; i < node->mNumMeshes; ++i) {
      const aiMesh& part = *scene.mMeshes[node->mMeshes[i]];
      const int first = static_cast<int>(mesh.vertices.size());
      const std::size_t first_triangle = mesh.triangles.size();
      if (mesh.vertices.size() + part.mNumVertices > kMostVertices) {
        throw InputError("more than 50 million vertices");
      }
      for (unsigned k = 0; k < part.mNumVertices; ++k) {
        mesh.vertices.push_back(X_FileNode * vertex_of(part, k));
      }
      for (unsigned k = 0; k < part.mNumFaces; ++k) add_face(mesh, part, part.mFaces[k], first);
      for (std::size_t t = first_triangle; mirrored && t < mesh.triangles.size(); ++t) {
        std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
      }
    }
    for (unsigned i = node->mNumChildren; i-- > 0;)
      open.emplace_back(node->mChildren[i], X_FileNode);
  }
}

}  // namespace

TriangleMesh read_with_assimp(const std::string& bytes, const std::string& extension) {
  try {
    Assimp::Importer importer;
    keep_importers(importer, extension);
    // Axes are used as written: converting Z_UP to Y_UP would lay the objects down.
    importer.SetPropertyInteger(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, 1);
    const std::string name = "mesh." + extension;
    // The importer takes ownership of its file system.
    importer.SetIOHandler(new ClosedFileSystem(name, bytes));
    const aiScene* scene = importer.ReadFile(name, 0);
    TriangleMesh mesh;
    if (scene == nullptr)
      throw InputError("cannot be read as " + extension + ": " +
                       one_line(importer.GetErrorString()));
    if (scene->mRootNode != nullptr) add_nodes(mesh, *scene);
    return mesh;
  } catch (const InputError&) {
    throw;
    // assimp reports errors by a null scene, but allocation failures and some parsers throw.
  } catch (const std::bad_alloc&) {
    throw InputError("cannot be read as " + extension + ": too large for the memory");
  } catch (const std::exception& error) {
    throw InputError("cannot be read as " + extension + ": " + one_line(error.what()));
  }
}

}  // namespace prehend
