#include "Imaging/postoperative_head.hpp"

#include "Imaging/moved_ct.hpp"

namespace f2b
{

PostoperativeHead
find_postoperative_head(const CtImage& preoperative_ct, const WholeBone& preoperative,
                        const BinaryMask& unaltered, const CtImage& postoperative_ct,
                        const SegmentOptions& segment, const RegisterCtOptions& options,
                        const Progress& progress)
{
  const WholeBone postoperative = find_whole_bone(postoperative_ct, "the post-operative CT");
  PostoperativeHead found;
  found.registration = register_ct(preoperative_ct, preoperative, unaltered, postoperative_ct,
                                   postoperative, options, progress);
  const RigidMotion back = inverse(found.registration.to_postoperative);
  found.head = segment_head(*moved_ct(postoperative_ct, back), segment, progress);
  return found;
}

} // namespace f2b
