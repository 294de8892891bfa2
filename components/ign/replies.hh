#pragma once

namespace pongsim::ign {

/// Records that a handler is about to return a reply. The library sends it afterwards on its own thread: it first
/// connects to the requester, which takes 100 ms, and does not report completion. For any thread.
void replyGiven();

/// Waits until the last reply has had half a second to be sent, so that it is not lost if the process exits on request.
/// Returns immediately if there was none recently. For any thread.
void awaitReplies();

}  // namespace pongsim::ign
