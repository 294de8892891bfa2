#pragma once

namespace pongsim::ign {

/// Records that a handler is about to return a reply. The library sends the reply afterwards, on its own thread: it
/// first connects to the requester, which takes 100 ms, and it does not report completion. For any thread.
void replyGiven();

/// Waits until half a second has passed since the last reply was returned, so that the reply to a request that ends the
/// process is sent. Returns immediately if that is long ago. For any thread.
void awaitReplies();

}  // namespace pongsim::ign
