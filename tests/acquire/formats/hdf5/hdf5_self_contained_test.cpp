#include "acquire/formats/hdf5/hdf5_self_contained.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "acquire/formats/hdf5/hdf5_handle.hpp"
#include "support/files/hdf5_builder.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::acquire::hdf5_self_contained_test {

using hdf5::Handle;
using test::Hdf5Builder;
using testing::HasSubstr;

class SelfContained : public testing::Test {
 protected:
  template <class Add>
  void check(Add&& add) const {
    {
      Hdf5Builder file(path_);
      file.ramp("x", {3});
      add(file.id());
    }
    const hdf5::Lock lock;
    hdf5::require_self_contained(path_);
  }
  template <class Add>
  std::string refusal(Add&& add) const {
    return test::input_error_of([&] { check(add); });
  }
  test::ScratchFolder folder_;
  std::string path_ = folder_.file("x.mat");
};

void add_references(hid_t file, const std::vector<hobj_ref_t>& references, const char* name = "refs") {
  const hsize_t count = references.size();
  const Handle space(H5Screate_simple(1, &count, nullptr));
  const Handle set(H5Dcreate2(file, name, H5T_STD_REF_OBJ, space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  ASSERT_TRUE(set);
  if (count == 0) return;
  ASSERT_GE(H5Dwrite(set.get(), H5T_STD_REF_OBJ, H5S_ALL, H5S_ALL, H5P_DEFAULT, references.data()), 0);
}

hobj_ref_t reference_to(hid_t file, const char* name) {
  hobj_ref_t out = 0;
  EXPECT_GE(H5Rcreate(&out, file, name, H5R_OBJECT, -1), 0);
  return out;
}

TEST_F(SelfContained, MayHoldGroupsHardLinksAndReferences) {
  EXPECT_NO_THROW(check([](hid_t file) {
    Handle(H5Gcreate2(file, "group", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)).close();
    H5Lcreate_hard(file, "x", file, "group/again", H5P_DEFAULT, H5P_DEFAULT);
    // A reference to a group, a null reference, and a reference to a place without an object.
    add_references(file, {reference_to(file, "group"), 0, 54'321});
    add_references(file, {}, "none");
  }));
}

TEST_F(SelfContained, MayNotHoldOtherLinks) {
  EXPECT_THAT(refusal([](hid_t file) { H5Lcreate_soft("/x", file, "y", H5P_DEFAULT, H5P_DEFAULT); }),
              HasSubstr("soft link (" + path_ + ": /y)"));
  EXPECT_THAT(refusal([](hid_t file) { H5Lcreate_external("o.h5", "/x", file, "y", H5P_DEFAULT, H5P_DEFAULT); }),
              HasSubstr("link to another file (" + path_ + ": /y)"));
  EXPECT_THAT(refusal([](hid_t file) {
                H5L_class_t kind{};
                kind.version = H5L_LINK_CLASS_T_VERS;
                kind.id = static_cast<H5L_type_t>(100);
                kind.trav_func = [](const char*, hid_t, const void*, size_t, hid_t, hid_t) -> hid_t { return -1; };
                ASSERT_GE(H5Lregister(&kind), 0);
                ASSERT_GE(H5Lcreate_ud(file, "y", kind.id, nullptr, 0, H5P_DEFAULT, H5P_DEFAULT), 0);
              }),
              HasSubstr("user-defined link (" + path_ + ": /y)"));
  H5Lunregister(static_cast<H5L_type_t>(100));
}

TEST_F(SelfContained, MayNotHoldSamplesInOtherFiles) {
  const hsize_t three = 3;
  const Handle space(H5Screate_simple(1, &three, nullptr));
  const auto with = [&](auto&& set_source) {
    return refusal([&](hid_t file) {
      const Handle creation(H5Pcreate(H5P_DATASET_CREATE));
      set_source(creation.get());
      const Handle set(H5Dcreate2(file, "y", H5T_IEEE_F64LE, space.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT));
      ASSERT_TRUE(set);
    });
  };
  const std::string refused = "its samples are in other files (" + path_ + ": /y)";
  EXPECT_THAT(with([&](hid_t creation) { H5Pset_virtual(creation, space.get(), "o.h5", "x", space.get()); }),
              HasSubstr(refused));
  EXPECT_THAT(with([](hid_t creation) { H5Pset_external(creation, "o.raw", 0, 24); }), HasSubstr(refused));
}

TEST_F(SelfContained, MayNotHoldReferencesToRegionsOrDamagedOnes) {
  const hsize_t three = 3;
  const Handle space(H5Screate_simple(1, &three, nullptr));
  EXPECT_THAT(
      refusal([&](hid_t file) {
        Handle(H5Dcreate2(file, "y", H5T_STD_REF_DSETREG, space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)).close();
      }),
      HasSubstr("references to regions of data sets (" + path_ + ": /y)"));
  EXPECT_THAT(
      refusal([&](hid_t file) {
        const Handle creation(H5Pcreate(H5P_DATASET_CREATE));
        H5Pset_chunk(creation.get(), 1, &three);
        H5Pset_deflate(creation.get(), 1);
        const Handle set(H5Dcreate2(file, "y", H5T_STD_REF_OBJ, space.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT));
        const hsize_t first = 0;
        ASSERT_GE(H5Dwrite_chunk(set.get(), H5P_DEFAULT, 0, &first, 4, "????"), 0);
      }),
      HasSubstr("damaged references (" + path_ + ": /y)"));
}

// Each link to the same object counts: a link beyond the limit may lead out of the file.
TEST_F(SelfContained, HaveAHundredThousandLinksInAGroupAtMost) {
  EXPECT_THAT(refusal([](hid_t file) {
                for (int n = 0; n < 100'000; ++n)
                  H5Lcreate_hard(file, "x", file, std::to_string(n).c_str(), H5P_DEFAULT, H5P_DEFAULT);
                H5Lcreate_soft("/x", file, "z", H5P_DEFAULT, H5P_DEFAULT);
              }),
              HasSubstr("more than 100000 links in a group"));
}

TEST_F(SelfContained, HaveLimits) {
  EXPECT_THAT(refusal([](hid_t file) { add_references(file, std::vector<hobj_ref_t>(100'001, 0)); }),
              HasSubstr("more than 100000 references"));
  std::vector<hobj_ref_t> places;
  for (hobj_ref_t place = 1; place <= 100'000; ++place) places.push_back(1'000'000 + place);
  EXPECT_THAT(refusal([&](hid_t file) { add_references(file, places); }), HasSubstr("more than 100000 objects"));
  EXPECT_THAT(refusal([](hid_t file) {
                std::string name = "g";
                for (int level = 0; level < 33; ++level, name += "/g")
                  Handle(H5Gcreate2(file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)).close();
              }),
              HasSubstr("groups within groups more than 32 deep"));
}

}  // namespace percuss::acquire::hdf5_self_contained_test
