-- | Every error in plain words: what is wrong and, unless it is obvious, what to do.
module Message
  ( module Message.Certificate,
    module Message.Chance,
    module Message.Code,
    module Message.Files,
    module Message.Format,
    module Message.Locate,
    module Message.Objects,
    module Message.Solid,
    module Message.Touch,
  )
where

import Message.Certificate
import Message.Chance
import Message.Code
import Message.Files
import Message.Format
import Message.Locate
import Message.Objects
import Message.Solid
import Message.Touch
