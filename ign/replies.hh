#pragma once

namespace pongsim::ign {

/// Says that a handler is about to return a reply. The library sends it after that, from a thread of its own: it first
/// connects to who asked, which takes it 100 ms, and tells nobody when it is done. Any thread.
void replyGiven();

/// Waits until the last reply has had half a second to leave, so that it is not lost where the process ends on a
/// request. Returns at once where there was none lately. Any thread.
void awaitReplies();

}  // namespace pongsim::ign
