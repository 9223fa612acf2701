#include "gpu/opengl/program_cache.h"

#include "gpu/opengl/gl_error.h"
#include "gpu/opengl/gl_program.h"
#include "gpu/raster/gl_render_program.h"
#include "tests/support/opengl.h"
#include "tests/support/scratch_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace program_cache_test {
namespace {

using test_support::gl_device;

namespace fs = std::filesystem;

// A folder of this test alone, gone afterwards.
struct Folder {
  const test_support::ScratchFolder whole;
  const fs::path path = whole.path() / "programs";

  std::vector<fs::path> files() const {
    std::vector<fs::path> result;
    if (!fs::exists(path)) return result;
    for (const auto& entry : fs::directory_iterator(path)) result.push_back(entry.path());
    return result;
  }
};

gpu::ProgramBinary binary_of(const std::string& text) {
  gpu::ProgramBinary binary;
  binary.format = 0x8e21u;
  for (const char c : text) binary.bytes.push_back(static_cast<std::byte>(c));
  return binary;
}

void overwrite(const fs::path& file, std::streamoff at, char value) {
  std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
  stream.seekp(at);
  stream.put(value);
}

TEST(ProgramCache, GivesBackWhatItWasGiven) {
  const Folder folder;
  const gpu::ProgramCache cache(folder.path / "deep", "driver 1");
  EXPECT_FALSE(cache.find("source"));
  cache.keep("source", binary_of("program"));
  cache.keep("other", binary_of("other program"));
  const auto found = gpu::ProgramCache(folder.path / "deep", "driver 1").find("source");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->format, 0x8e21u);
  EXPECT_EQ(found->bytes, binary_of("program").bytes);
  EXPECT_FALSE(cache.find("a third"));
}

TEST(ProgramCache, OtherDriversHaveOtherPrograms) {
  const Folder folder;
  gpu::ProgramCache(folder.path, "driver 1").keep("source", binary_of("program"));
  const gpu::ProgramCache other(folder.path, "driver 2");
  EXPECT_FALSE(other.find("source"));
  // Not even under the name that the other driver's would have.
  other.keep("source", binary_of("program 2"));
  const std::vector<fs::path> files = folder.files();
  ASSERT_EQ(files.size(), 2u);
  fs::copy_file(files[0], files[1], fs::copy_options::overwrite_existing);
  EXPECT_NE(other.find("source").has_value(),
            gpu::ProgramCache(folder.path, "driver 1").find("source").has_value());
}

TEST(ProgramCache, DamagedFilesCountAsNone) {
  const Folder folder;
  const gpu::ProgramCache cache(folder.path, "driver");
  const gpu::ProgramBinary program = binary_of("program");
  cache.keep("source", program);
  const fs::path file = folder.files().at(0);
  const auto size = static_cast<std::streamoff>(fs::file_size(file));
  for (std::streamoff at = 0; at < size; ++at) {
    cache.keep("source", program);
    ASSERT_TRUE(cache.find("source"));
    overwrite(file, at, '\x7f');
    EXPECT_FALSE(cache.find("source")) << "byte " << at;
  }
  for (const std::uintmax_t length :
       {std::uintmax_t{0}, std::uintmax_t{20}, fs::file_size(file) - 1}) {
    cache.keep("source", program);
    fs::resize_file(file, length);
    EXPECT_FALSE(cache.find("source")) << length << " bytes";
  }
  cache.keep("source", program);
  EXPECT_TRUE(cache.find("source"));
  EXPECT_EQ(folder.files().size(), 1u) << "nothing half-written is left";
}

TEST(ProgramCache, FoldersThatCannotBeWrittenDoNotMatter) {
  const gpu::ProgramCache off;
  off.keep("source", binary_of("program"));
  EXPECT_FALSE(off.find("source"));
  const Folder folder;
  { std::ofstream(folder.path) << "a file where the folder should be"; }
  const gpu::ProgramCache blocked(folder.path, "driver");
  blocked.keep("source", binary_of("program"));
  EXPECT_FALSE(blocked.find("source"));
  // Nobody, not even root, makes folders there.
  const gpu::ProgramCache read_only("/proc/luxgate", "driver");
  read_only.keep("source", binary_of("program"));
  EXPECT_FALSE(read_only.find("source"));
}

// --- with a driver
// --------------------------------------------------------------------------------

const char* const kShader = R"glsl(#version 430
layout(local_size_x = 1) in;
layout(std430, binding = 0) writeonly buffer A { uint a[]; };
void main() { a[0] = 7u; }
)glsl";

bool is_from_cache(const fs::path& folder) {
  std::string problem;
  bool result = false;
  const auto device = gpu::DeviceThread::open({-1, gpu::Fault::none, folder}, problem);
  device->run([&](gpu::DeviceState& state) {
    result = gpu::GlProgram("a test", kShader, state.programs).is_from_cache();
  });
  return result;
}

TEST(GlProgram, IsCompiledOnceForAllRuns) {
  LUXGATE_NEEDS_OPENGL();
  const Folder folder;
  EXPECT_FALSE(is_from_cache(folder.path));
  if (folder.files().empty()) GTEST_SKIP() << "this driver gives no binaries";
  EXPECT_TRUE(is_from_cache(folder.path));
  EXPECT_FALSE(is_from_cache(""));
  overwrite(folder.files().at(0), 200, '\x7f');
  EXPECT_FALSE(is_from_cache(folder.path));
  EXPECT_TRUE(is_from_cache(folder.path)) << "the damaged file was not replaced";
}

TEST(GlRenderProgram, IsCompiledOnceForAllRuns) {
  LUXGATE_NEEDS_OPENGL();
  const Folder folder;
  gl_device()->run([&](gpu::DeviceState&) {
    const gpu::ProgramCache cache(folder.path, "driver");
    const gpu::GlRenderProgram first("a test", gpu::picture_shaders(false), cache);
    EXPECT_FALSE(first.is_from_cache());
    if (folder.files().empty()) return;  // this driver gives no binaries
    const gpu::GlRenderProgram again("a test", gpu::picture_shaders(false), cache);
    EXPECT_TRUE(again.is_from_cache());
    again.use();
    again.set("clip_from_local", glm::mat4(1.0f));
    EXPECT_NO_THROW(gpu::check_gl("using a program of the cache"));
    const gpu::GlRenderProgram other("a test", gpu::picture_shaders(true), cache);
    EXPECT_FALSE(other.is_from_cache());
  });
}

// What a driver says no to is compiled again.
TEST(GlProgram, SurvivesBinariesOfAnotherDriver) {
  LUXGATE_NEEDS_OPENGL();
  const Folder folder;
  gl_device()->run([&](gpu::DeviceState&) {
    const gpu::ProgramCache cache(folder.path, "driver");
    gpu::ProgramBinary foreign = binary_of(std::string(500, 'x'));
    for (const std::uint32_t format : {0x8e21u, 0x1234u, 0x875fu}) {
      foreign.format = format;
      cache.keep(kShader, foreign);
      const gpu::GlProgram program("a test", kShader, cache);
      EXPECT_FALSE(program.is_from_cache()) << format;
      program.use();
    }
  });
}

}  // namespace
}  // namespace program_cache_test
